#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/axis_angle.hpp>
#include <rotconv/comparison.hpp>
#include <rotconv/quaternion.hpp>

#include "../../stream/numbers/json.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

using operations::PairLimit;

/// A constant rotation as an option, --left or --right.
struct FoundRotation {
    std::string_view side;
    std::string text;
    FixedRotation rotation; ///< as the text has it
    double size;            ///< of what was found, radians
};
using FoundRotations = std::vector<FoundRotation>;

/// @param found rotations of attitudes that were rotated as `given`
FoundRotations found_rotations(const ConstantRotations& found, const ConversionSettings& given) {
    FoundRotations rotations;
    const auto add = [&](std::string_view side, const Rotation& rotation, const FixedRotation& all) {
        if (!all.rotation.is_identity()) {
            const Eigen::Quaterniond q = quaternion::from_rotation(all.rotation);
            const std::array numbers{q.w() + 0.0, q.x() + 0.0, q.y() + 0.0, q.z() + 0.0}; // no -0
            rotations.push_back({side, fmt::format("quat: {}", fmt::join(numbers, " ")),
                                 FixedRotation::of_numbers(Spec{}, numbers),
                                 axis_angle::from_rotation(rotation).angle});
        }
    };
    add("left", found.left, found.left * given.left);
    add("right", found.right, given.right * found.right);
    return rotations;
}

/// How many pairs must have been compared.
struct LeastPairs {
    std::string text{}; ///< as it is given; empty: by default
    std::size_t pairs = 0;
    double percent = 0.0; ///< of FILE's data rows
};

/// What is to be told of the pairs, and what they must hold to.
struct Check {
    stream::Format format = stream::Format::pretty;
    stream::Digits digits{};              ///< of the numbers that are told
    AngleUnitName unit{};                 ///< of the angles that are told
    std::array<bool, 2> allow_unpaired{}; ///< rows of FILE, of REFERENCE
    LeastPairs least_pairs{};
    std::size_t worst = 0; ///< pairs to show
    operations::ComparisonRows rows{};
    ComparisonSettings comparing{};
    std::shared_ptr<const operations::PairFold> pairs{};
    std::shared_ptr<const FoundRotations> aligned{}; ///< null: they are not
};

bool has_pairs(const Check& check) { return check.pairs->pairs() > 0; }

/// The pair that differs most; an empty one without pairs.
operations::WorstPair worst(const Check& check) {
    return has_pairs(check) ? *check.pairs->worst().begin() : operations::WorstPair();
}

std::string number(const Check& check, double value) { return stream::number_text(value, check.digits); }

/// The angle in the unit of the report.
double in_unit(const Check& check, double radians) { return check.unit.per_radian * radians; }

/// The angle with its unit.
std::string angle(const Check& check, double value) {
    return fmt::format("{} {}", number(check, value), check.unit.text);
}

/// What a limit is for, among the pairs.
double figure_of(const Check& check, const PairLimit& limit) {
    if (limit.is_of_all()) {
        return worst(check).angle;
    }
    const double estimate = check.pairs->angles().percentile(limit.percent); // which must not belie the count
    return limit.holds(check.pairs->pairs()) ? std::min(estimate, limit.angle) : std::max(estimate, limit.angle);
}

/// The angle of a limit as it is given, or in the unit of the figures.
std::string text_of(const Check& check, const PairLimit& limit) {
    return limit.text.ends_with(fmt::format(" {}", check.unit.text)) ? limit.text : angle(check, limit.angle);
}

/// What pairs within all limits are like.
std::string figures_of_limits(const Check& check) {
    std::string text;
    for (const PairLimit& limit : check.pairs->limits()) {
        text +=
            fmt::format("{} {}, limit {}, ", limit.name, angle(check, figure_of(check, limit)), text_of(check, limit));
    }
    return text + counted(check.pairs->pairs(), "pair");
}

/// Why a limit does not hold; empty if it does.
std::string fault_of_limit(const Check& check, const PairLimit& limit) {
    return limit.holds(check.pairs->pairs())
               ? ""
               : fmt::format("{} {} is beyond {}, {} of {}, first at line {}", limit.name,
                             angle(check, figure_of(check, limit)), text_of(check, limit), limit.beyond,
                             counted(check.pairs->pairs(), "pair"), limit.first_beyond);
}

/// Why too few pairs were compared; empty if there are enough.
std::string fault_of_count(const Check& check, const RowsResult& result) {
    const LeastPairs& least = check.least_pairs;
    if (result.answered >= least.pairs && operations::is_share(result.answered, least.percent, result.rows)) {
        return {};
    }
    return fmt::format("{} of {} compared (--min-pairs{})", result.answered,
                       least.percent > 0.0 ? "FILE's " + counted(result.rows, "row") : counted(least.pairs, "pair"),
                       least.text.empty() ? ": at least half, unless it says otherwise" : " " + least.text);
}

/// What does not hold, `few` and others; empty if all does.
std::string fault_of(const Check& check, const RowsCommand& command, const RowsResult& result, const std::string& few) {
    std::vector<std::string> faults =
        mapped(check.pairs->limits(), [&check](const PairLimit& limit) { return fault_of_limit(check, limit); });
    faults.insert(has_pairs(check) ? faults.end() : faults.begin(), few);
    for (const std::size_t side : {0U, 1U}) {
        const std::size_t rows = result.unpaired.at(side).rows;
        if (rows > 0 && !check.allow_unpaired.at(side)) {
            faults.push_back(fmt::format("{} of {} unpaired", counted(rows, "row"), side == 0 ? "FILE" : "REFERENCE"));
        }
    }
    const bool has_failures = result.failed[0] + result.failed[1] > 0;
    if (has_failures && !command.allow_failed) {
        faults.push_back(result.failed[0] > 0 ? counted(result.failed[0], "row") + " failed" : "");
        faults.push_back(result.failed[1] > 0 ? counted(result.failed[1], "row") + " of REFERENCE failed" : "");
    } else if (result.code == ExitCode::completed_with_failures) {
        faults.emplace_back("--strict met a diagnostic");
    }
    std::erase(faults, "");
    return joined(faults, "; ");
}

/// The rotations on one side that leave less than a hundredth, if there are any, and what they leave, in radians.
std::optional<std::pair<FoundRotations, double>> constant(const Check& check) {
    if (check.rows.delta > 0 || check.pairs->pairs() < 2) {
        return std::nullopt;
    }
    const double all = check.pairs->angles().root_mean_square() / in_unit(check, 1.0);
    const double left = check.pairs->left().rms();
    const double right = check.pairs->right().rms();
    constexpr double rounding = 0x1p-50;
    const bool is_left = left <= std::max(1.01 * right, rounding); // of equals
    const double remainder = is_left ? left : right;
    if (!(remainder < 0.01 * all) || all < rounding) {
        return std::nullopt;
    }
    const ConstantRotations found{is_left ? check.pairs->left().mean() : Rotation(),
                                  is_left ? Rotation() : check.pairs->right().mean()};
    return std::pair(found_rotations(found, check.comparing.reading), remainder);
}

/// The figures of all angles by their names.
std::vector<std::pair<std::string_view, double>> figures(const Check& check) {
    const operations::AngleStatistics& all = check.pairs->angles();
    return {{"rms", all.root_mean_square()},
            {"mean", all.mean()},
            {"std", all.standard_deviation()},
            {"median", all.percentile(50.0)},
            {"p95", all.percentile(95.0)}};
}

/// The limit without a percentage, or null.
const PairLimit* limit_of_all(const Check& check) {
    const auto found = std::ranges::find_if(check.pairs->limits(), &PairLimit::is_of_all);
    return found == check.pairs->limits().end() ? nullptr : &*found;
}

std::string in_words(const Check& check, const FoundRotations& rotations) {
    std::string sizes;
    std::string options;
    for (const FoundRotation& each : rotations) {
        sizes += (sizes.empty() ? "" : " and ") + angle(check, in_unit(check, each.size));
        options += fmt::format(" --{} '{}'", each.side, each.text);
    }
    return options.empty() ? "by nothing" : fmt::format("by {}:{}", sizes, options);
}

std::string in_lines(const Check& check, const RowsResult& result) {
    std::string text;
    const auto add = [&text](std::string_view name, const auto& value) {
        text += fmt::format("{:9} {}\n", name, value);
    };
    const auto at = [&check](std::size_t row, const std::string& key) {
        return fmt::format("{}{}", row, check.rows.by_key ? fmt::format(" (key {})", key) : "");
    };
    const auto where = [&](const operations::WorstPair& pair) {
        return fmt::format("{} at {}", angle(check, pair.angle), at(pair.line, pair.keys[0]));
    };
    add("rows", check.pairs->pairs());
    if (const auto* limit = limit_of_all(check)) {
        add("beyond", limit->beyond);
    }
    const auto& [own, other] = result.unpaired;
    const auto& [failed, failed_reference] = result.failed;
    const auto of_both = [](std::size_t rows, std::size_t reference_rows) {
        return fmt::format("{} of FILE, {} of REFERENCE", rows, reference_rows);
    };
    add("unpaired", own.rows + other.rows == 0 ? "0" : of_both(own.rows, other.rows));
    add("failed", failed_reference == 0 ? fmt::format("{}", failed) : of_both(failed, failed_reference));
    if (check.aligned) {
        add("aligned", in_words(check, *check.aligned));
    }
    if (has_pairs(check)) {
        add("max", where(worst(check)));
        for (const auto& [name, value] : figures(check)) {
            add(name, angle(check, value));
        }
        for (const PairLimit& limit : check.pairs->limits()) {
            if (limit.percent != 50.0 && limit.percent != 95.0 && !limit.is_of_all()) {
                add(limit.name, angle(check, figure_of(check, limit)));
            }
        }
    }
    if (const auto found = constant(check)) {
        add("constant", fmt::format("{}, which leaves {}", in_words(check, found->first),
                                    angle(check, in_unit(check, found->second))));
    }
    std::size_t shown = 0;
    for (const operations::WorstPair& pair :
         check.worst > 0 ? check.pairs->worst() : std::set<operations::WorstPair>()) {
        const std::string reference =
            pair.reference_line > 0 ? ", reference " + at(pair.reference_line, pair.keys[1]) : "";
        add(fmt::format("worst {}", ++shown),
            fmt::format("{}{}: {} against {}", where(pair), reference, fmt::join(pair.attitudes[0], " "),
                        fmt::join(pair.attitudes[1], " ")));
    }
    return text;
}

/// A figure for JSON; null without a pair.
JsonValue figure(const Check& check, double value) {
    return has_pairs(check) ? JsonValue::as_written(number(check, value)) : JsonValue();
}

JsonValue in_json(const Check& check, const FoundRotations& rotations) {
    std::vector<std::pair<std::string_view, JsonValue>> object;
    for (const FoundRotation& each : rotations) {
        object.emplace_back(each.side, each.text);
        object.emplace_back(each.side == "left" ? "left_angle" : "right_angle",
                            figure(check, in_unit(check, each.size)));
    }
    return json_object(object);
}

JsonValue limits_in_json(const Check& check) {
    const auto limits = mapped(check.pairs->limits(), [&check](const PairLimit& limit) {
        return json_object({{"percent", limit.percent},
                            {"angle", limit.angle},
                            {"beyond", limit.beyond},
                            {"percentile", figure(check, figure_of(check, limit))}});
    });
    return json_array(limits).unless(limits.empty());
}

/// The key of a row or, from 1, of its partner.
JsonValue key(const Check& check, const operations::WorstPair& pair, std::size_t side) {
    const std::string& text = pair.keys.at(side);
    return !check.rows.by_key ? JsonValue() : stream::is_json_number(text) ? JsonValue::as_written(text) : text;
}

JsonValue worst_in_json(const Check& check) {
    const auto pairs = mapped(check.pairs->worst(), [&check](const operations::WorstPair& pair) {
        return json_object({{"angle", figure(check, pair.angle)},
                            {"line", pair.line},
                            {"reference_line", JsonValue(pair.reference_line).unless(pair.reference_line == 0)},
                            {"key", key(check, pair, 0)},
                            {"reference_key", key(check, pair, 1)},
                            {"attitude", json_array(pair.attitudes[0])},
                            {"reference", json_array(pair.attitudes[1])}});
    });
    return json_array(pairs).unless(check.worst == 0);
}

std::string in_json(const Check& check, const RowsCommand& command, const RowsResult& result,
                    const JsonValue& verdict) {
    const PairLimit* const of_all = limit_of_all(check);
    const PairLimit limit = of_all != nullptr ? *of_all : PairLimit();
    const operations::WorstPair farthest = worst(check);
    std::vector<std::pair<std::string_view, JsonValue>> object{
        {"rows", check.pairs->pairs()},
        {"unit", std::string(check.unit.text)},
        {"file", command.has_values ? "argument" : command.input},
        {"reference", JsonValue(command.reference).unless(command.reference.empty())},
        {"version", ROTCONV_VERSION},
        {"within", JsonValue(limit.angle).unless(of_all == nullptr)},
        {"beyond", JsonValue(limit.beyond).unless(of_all == nullptr)},
        {"first_beyond", JsonValue(limit.first_beyond).unless(limit.beyond == 0)},
        {"limits", limits_in_json(check)},
        {"unpaired", result.unpaired[0].rows + result.unpaired[1].rows},
        {"unpaired_file", result.unpaired[0].rows},
        {"unpaired_reference", result.unpaired[1].rows},
        {"failed", result.failed[0]},
        {"failed_reference", result.failed[1]},
        {"max", figure(check, farthest.angle)},
        {"max_line", JsonValue(farthest.line).unless(!has_pairs(check))},
        {"max_key", key(check, farthest, 0).unless(!has_pairs(check))}};
    for (const auto& [name, value] : figures(check)) {
        object.emplace_back(name, figure(check, value));
    }
    const auto found = constant(check);
    object.emplace_back("constant", found ? in_json(check, found->first) : JsonValue());
    object.emplace_back("aligned", check.aligned ? in_json(check, *check.aligned) : JsonValue());
    object.emplace_back("worst", worst_in_json(check));
    object.emplace_back("verdict", verdict);
    return json_line(object);
}

/// The report and the verdict.
Conclusion conclusion_of(const Check& check, const RowsCommand& command, const RowsResult& result) {
    const std::size_t alone = result.unpaired[0].rows + (result.keys.any_pair ? 0 : result.unpaired[1].rows);
    if (check.rows.by_key && 2 * alone > result.rows) {
        print_error(messages::few_keys_met(result.keys, *command.options.pairing));
    } else if (!has_pairs(check) && result.code == ExitCode::done) {
        print_error(check.rows.delta > 0 && result.answered > 0 ? "no pair has one after it at the distance of --delta"
                                                                : std::string(messages::nothing_read));
    }
    const std::string too_few = fault_of_count(check, result);
    const bool names_count = !check.least_pairs.text.empty() && !too_few.empty();
    const std::string few = has_pairs(check) ? too_few : names_count ? "no pairs; " + too_few : "no pairs";
    const std::string fault = fault_of(check, command, result, few);
    const bool is_csv = check.format == stream::Format::csv;
    const auto tell = [&check](const std::string& found) {
        if (has_pairs(check) && !found.empty()) {
            print_error(found);
        }
    };
    for (const PairLimit& limit : check.pairs->limits()) {
        tell(is_csv && !limit.is_of_all() ? fault_of_limit(check, limit) : ""); // of which the rows do not tell
    }
    tell(is_csv || check.pairs->limits().empty() ? few : "");
    Conclusion conclusion{.text = "", .holds = fault.empty()};
    if (!is_csv) {
        const std::string verdict = check.pairs->limits().empty() ? "not checked: no --within"
                                    : fault.empty()               ? "pass: " + figures_of_limits(check)
                                                                  : "fail: " + fault;
        conclusion.text = check.format == stream::Format::json
                              ? in_json(check, command, result, check.pairs->limits().empty() ? JsonValue() : verdict)
                              : in_lines(check, result) + verdict + "\n";
    }
    return conclusion;
}

// NOLINTBEGIN(cert-err58-cpp): without memory nothing works
const Choices<AlignedSide> sides{{"reference", AlignedSide::reference},
                                 {"body", AlignedSide::body},
                                 {"both", AlignedSide::both},
                                 {"yaw", AlignedSide::yaw},
                                 {"first", AlignedSide::first}};
/// Of FILE and of REFERENCE.
const Choices<std::array<bool, 2>> unpaired_rows{
    {"file", {true, false}}, {"reference", {false, true}}, {"both", {true, true}}};
// NOLINTEND(cert-err58-cpp)

struct CompareOptions final : RowOptions {
    CompareOptions() {
        to.about = "The representation of the reference (default: that of --from)";
        format.about = "pretty (default), json, or csv: every pair with its angle";
        format.choices = {"pretty", "json", "csv"};
        within.repeats = true;
        add("What", {&from, &to, &align, &delta});
        add_attitudes_of_file("Turn the attitudes R of FILE: compare L R; L as \"SPEC: NUMBERS\"",
                              "Turn the attitudes R of FILE: compare R S; S as \"SPEC: NUMBERS\"");
        add("Check", {&within, &allow_unpaired, &allow_failed, &min_pairs});
        add_pairing();
        add("Columns", {&interpolate});
        add_reading();
        add_writing();
        add("Output", {&worst});
        add("Errors", {&lock_margin});
    }

    [[nodiscard]] Command command() const override {
        using stream::Format;
        const Spec read = spec_of(from);
        const Spec reference = to.given() ? spec_of(to) : read;
        const auto side = one_of("side of --align", align, sides);
        const auto written = one_of("format of compare", format, formats);
        const bool in_spec = read.unit == AngleUnit::degrees || reference.unit == AngleUnit::degrees;
        AngleUnitName unit = degrees.given() || in_spec ? in_degrees : AngleUnitName();
        std::vector<PairLimit> limits = limits_of_within(unit);
        Check check{.format = written,
                    .unit = unit,
                    .least_pairs = least_pairs(),
                    .worst = count_of(worst, 1'000'000),
                    .comparing = {.reading = attitude_settings(), .per_radian = unit.per_radian}};
        if (allow_unpaired.given()) {
            check.allow_unpaired = one_of("kind of rows for --allow-unpaired", allow_unpaired, unpaired_rows);
        }
        for (const PairLimit& limit : limits) {
            check.comparing.within = limit.is_of_all() ? limit.angle : check.comparing.within;
        }
        const Comparison comparison(read, reference, check.comparing);
        const bool as_rows = written == Format::csv;
        const operations::ComparisonRows rows{{paired_rows()}, !as_rows, count_of(delta, 1'000'000), unit.text};
        check.rows = rows;
        const auto pairs = std::make_shared<operations::PairFold>(
            comparison, rows, std::max<std::size_t>(check.worst, 1), std::move(limits));
        check.pairs = pairs;
        RowsCommand made = rows_command(operations::compare(comparison, rows));
        pair(made, reference);
        made.options.append = as_rows;
        made.options.writes_rows = as_rows;
        made.options.fold = pairs;
        made.allow_failed = allow_failed.given();
        check.digits = made.options.digits;
        if (written == Format::pretty && check.digits.shortest()) {
            check.digits.significant = 6;
        }
        check.aligned = align.given() ? align_first(made, comparison, rows, side) : nullptr;
        made.is_check = true;
        made.conclude = [check](const RowsCommand& command, const RowsResult& result) {
            return conclusion_of(check, command, result);
        };
        return made;
    }

private:
    /// The percentage that a text is: above 0 and at most 100.
    [[nodiscard]] static std::optional<double> percentage(std::string_view text) {
        double percent = 0.0;
        const bool is_number = stream::read_number(text, percent) == stream::NumberError::none;
        return is_number && percent > 0.0 && percent <= 100.0 ? std::optional(percent) : std::nullopt;
    }

    /// The limits of --within, each an ANGLE or ANGLE@PERCENT. `unit` becomes that of the first that has one.
    [[nodiscard]] std::vector<PairLimit> limits_of_within(AngleUnitName& unit) const {
        std::vector<PairLimit> all;
        bool has_unit = false;
        for (const std::string& text : within.texts) {
            const std::size_t at = std::min(text.find('@'), text.size());
            const std::string given = text.substr(0, at);
            if (at == 0) {
                throw Usage("{} {} has a percentage, and no angle before it", within.name(), quoted(text));
            }
            const GivenAngle angle = given_angle(within, given, degrees.given());
            const std::string percent_text = at == text.size() ? "100" : text.substr(at + 1);
            const auto percent = percentage(percent_text);
            if (!percent) {
                throw Usage("{} {}: {} is not a percentage above 0 and at most 100", within.name(), quoted(text),
                            quoted(percent_text));
            }
            const bool is_of_all = *percent == 100.0;
            if (const auto same = std::ranges::find(all, *percent, &PairLimit::percent); same != all.end()) {
                throw Usage("{} {} and {} are two limits for {} pairs", within.name(), same->text, angle.text,
                            is_of_all ? "all" : fmt::format("{} in 100", percent_text));
            }
            unit = has_unit ? unit : angle.unit.value_or(unit);
            has_unit = has_unit || angle.unit;
            all.push_back({angle.text, is_of_all ? "max" : "p" + percent_text, angle.in(unit), *percent});
        }
        return all;
    }

    /// How many pairs a check needs: N, or N% of FILE's rows; where rows are allowed to be left out, by default half of
    /// them.
    [[nodiscard]] LeastPairs least_pairs() const {
        if (!min_pairs.given()) {
            return {.percent = allow_unpaired.given() || allow_failed.given() ? 50.0 : 0.0};
        }
        const std::string& text = min_pairs.text();
        if (!text.ends_with('%')) {
            return {.text = text, .pairs = count_of(min_pairs, 1'000'000'000'000'000)};
        }
        const auto percent = percentage(text.substr(0, text.size() - 1));
        if (!percent) {
            throw Usage("{} {} must be a whole number from 1, or a percentage above 0 and at most 100%",
                        min_pairs.name(), quoted(text));
        }
        return {.text = text, .percent = *percent};
    }

    /// Has the command find the rotations of --align first.
    /// @return where they will be
    [[nodiscard]] std::shared_ptr<FoundRotations> align_first(RowsCommand& made, const Comparison& comparison,
                                                              const operations::ComparisonRows& rows,
                                                              AlignedSide side) const {
        if (made.has_values || made.input == "-" || made.reference == "-") {
            throw Usage("{} reads its input twice: give FILEs, not VALUEs or stdin", align.name());
        }
        const operations::ComparisonRows as_they_are{{paired_rows()}, true};
        const auto fold = std::make_shared<operations::AlignmentFold>(side);
        auto found = std::make_shared<FoundRotations>();
        made.prepare = [=, name = std::string(align.name())](RowsCommand& command) -> std::optional<std::string> {
            if (auto wrong = look_through(command, operations::compare(comparison, as_they_are), fold)) {
                return wrong;
            }
            const auto best = fold->alignment.rotations();
            if (!best) {
                return fmt::format("the pairs do not determine the turn of {}", name);
            }
            ComparisonSettings rotated = comparison.settings();
            *found = found_rotations(*best, rotated.reading);
            rotated.reading.left = {};
            rotated.reading.right = {};
            for (const FoundRotation& each : *found) { // as the options have it
                (each.side == "left" ? rotated.reading.left : rotated.reading.right) = each.rotation;
            }
            command.options.operation =
                operations::compare(Comparison(comparison.from(), comparison.reference(), rotated), rows);
            return std::nullopt;
        };
        return found;
    }

    Option align{"--align", "SIDE", "Turn FILE by the best constant: reference, body, both, yaw, or first",
                 words_of(sides)};
    Option delta{"--delta", "N", "Compare the turns from each pair to the N-th after it"};
    Option within{"--within", "ANGLE", "The largest angle that passes, such as 0.3deg; 0.3deg@95: of 95 in 100"};
    Option allow_unpaired{"--allow-unpaired", "WHOSE", "Rows without a partner pass: file, reference or both",
                          words_of(unpaired_rows)};
    Option allow_failed{"--allow-failed", "", "Rows without an attitude pass, with --on-error skip or nan"};
    Option min_pairs{"--min-pairs", "N", "Pairs that must be compared, or N% of the rows (with --allow-...: 50%)"};
    Option worst{"--worst", "N", "Show the N pairs that differ most"};
};

} // namespace

CommandEntry compare_command() {
    return {"compare", "Check attitudes against a reference, by the angles between them",
            "Usage: rotconv compare -f SPEC [-t SPEC] [OPTION]... FILE REFERENCE\n"
            "       rotconv compare -f SPEC [-t SPEC] [OPTION]... [FILE]\n"
            "       rotconv compare -f SPEC [-t SPEC] [OPTION]... VALUE...\n",
            make_options<CompareOptions>, 2};
}

} // namespace rotconv::cli
