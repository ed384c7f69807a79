#include "comparison_report.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include <rotconv/axis_angle.hpp>
#include <rotconv/quaternion.hpp>

#include "../stream/fmt.hpp"
#include "../stream/json.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

using operations::PairLimit;

/// The report and the verdict.
class ComparisonReport {
public:
    ComparisonReport(const Check& check, const RowsCommand& command)
        : check_(check), command_(command), digits_(command.options.digits), pairs_(*check.pairs),
          unit_(check.unit.text) {
        if (check_.format == stream::Format::pretty && digits_.shortest()) {
            digits_.significant = 6;
        }
    }

    [[nodiscard]] Conclusion conclude(const RowsResult& result) const {
        const std::size_t alone = result.unpaired[0].rows + (result.keys.any_pair ? 0 : result.unpaired[1].rows);
        if (check_.rows.by_key && 2 * alone > result.rows) {
            print_error(messages::few_keys_met(result.keys));
        } else if (!has_pairs() && result.code == ExitCode::done) {
            print_error(check_.rows.delta > 0 && result.answered > 0
                            ? "no pair has one after it at the distance of --delta"
                            : std::string(messages::nothing_read));
        }
        const std::string too_few = fault_of_count(result);
        const bool names_count = !check_.least_pairs.text.empty() && !too_few.empty();
        const std::string few = has_pairs() ? too_few : names_count ? "no pairs; " + too_few : "no pairs";
        const std::string fault = fault_of(result, few);
        const bool is_csv = check_.format == stream::Format::csv;
        const auto tell = [this](const std::string& found) {
            if (has_pairs() && !found.empty()) {
                print_error(found);
            }
        };
        for (const PairLimit& limit : limits_) {
            tell(is_csv && !limit.is_of_all() ? fault_of_limit(limit) : ""); // of which the rows do not tell
        }
        tell(is_csv || limits_.empty() ? few : "");
        Conclusion conclusion{.text = "", .holds = fault.empty()};
        if (!is_csv) {
            const std::string verdict = limits_.empty() ? "not checked: no --within"
                                        : fault.empty() ? "pass: " + figures_of_limits()
                                                        : "fail: " + fault;
            conclusion.text = check_.format == stream::Format::json
                                  ? in_json(result, limits_.empty() ? JsonValue() : verdict)
                                  : in_lines(result) + verdict + "\n";
        }
        return conclusion;
    }

private:
    [[nodiscard]] bool has_pairs() const { return pairs_.pairs() > 0; }
    /// The pair that differs most; an empty one without pairs.
    [[nodiscard]] operations::WorstPair worst() const {
        return has_pairs() ? *pairs_.worst().begin() : operations::WorstPair();
    }
    [[nodiscard]] std::string number(double value) const { return stream::number_text(value, digits_); }
    /// The angle in the unit of the report.
    [[nodiscard]] double in_unit(double radians) const { return check_.unit.per_radian * radians; }
    /// The angle with its unit.
    [[nodiscard]] std::string angle(double value) const { return fmt::format("{} {}", number(value), unit_); }

    /// What a limit is for, among the pairs.
    [[nodiscard]] double figure_of(const PairLimit& limit) const {
        if (limit.is_of_all()) {
            return worst().angle;
        }
        const double estimate = pairs_.angles().percentile(limit.percent); // which must not belie the count
        return limit.holds(pairs_.pairs()) ? std::min(estimate, limit.angle) : std::max(estimate, limit.angle);
    }
    /// The angle of a limit as it is given, or in the unit of the figures.
    [[nodiscard]] std::string text_of(const PairLimit& limit) const {
        return limit.text.ends_with(fmt::format(" {}", unit_)) ? limit.text : angle(limit.angle);
    }
    /// What pairs within all limits are like.
    [[nodiscard]] std::string figures_of_limits() const {
        std::string text;
        for (const PairLimit& limit : limits_) {
            text += fmt::format("{} {}, limit {}, ", limit.name, angle(figure_of(limit)), text_of(limit));
        }
        return text + counted(pairs_.pairs(), "pair");
    }
    /// Why a limit does not hold; empty if it does.
    [[nodiscard]] std::string fault_of_limit(const PairLimit& limit) const {
        return limit.holds(pairs_.pairs())
                   ? ""
                   : fmt::format("{} {} is beyond {}, {} of {}, first at line {}", limit.name, angle(figure_of(limit)),
                                 text_of(limit), limit.beyond, counted(pairs_.pairs(), "pair"), limit.first_beyond);
    }
    /// Why too few pairs were compared; empty if there are enough.
    [[nodiscard]] std::string fault_of_count(const RowsResult& result) const {
        const LeastPairs& least = check_.least_pairs;
        if (result.answered >= least.pairs && operations::is_share(result.answered, least.percent, result.rows)) {
            return {};
        }
        return fmt::format("{} of {} compared (--min-pairs{})", result.answered,
                           least.percent > 0.0 ? "FILE's " + counted(result.rows, "row") : counted(least.pairs, "pair"),
                           least.text.empty() ? ": at least half, unless it says otherwise" : " " + least.text);
    }

    /// What does not hold, `few` and others; empty if all does.
    [[nodiscard]] std::string fault_of(const RowsResult& result, const std::string& few) const {
        std::vector<std::string> faults =
            mapped(limits_, [this](const PairLimit& limit) { return fault_of_limit(limit); });
        faults.insert(has_pairs() ? faults.end() : faults.begin(), few);
        for (const std::size_t side : {0U, 1U}) {
            const std::size_t rows = result.unpaired.at(side).rows;
            if (rows > 0 && !check_.allow_unpaired.at(side)) {
                faults.push_back(
                    fmt::format("{} of {} unpaired", counted(rows, "row"), side == 0 ? "FILE" : "REFERENCE"));
            }
        }
        const bool has_failures = result.failed[0] + result.failed[1] > 0;
        if (has_failures && !command_.allow_failed) {
            faults.push_back(result.failed[0] > 0 ? counted(result.failed[0], "row") + " failed" : "");
            faults.push_back(result.failed[1] > 0 ? counted(result.failed[1], "row") + " of REFERENCE failed" : "");
        } else if (result.code == ExitCode::completed_with_failures) {
            faults.emplace_back("--strict met a diagnostic");
        }
        std::erase(faults, "");
        return joined(faults, "; ");
    }

    /// The rotations on one side that leave less than a hundredth, if there are any, and what they leave, in radians.
    [[nodiscard]] std::optional<std::pair<FoundRotations, double>> constant() const {
        if (check_.rows.delta > 0 || pairs_.pairs() < 2) {
            return std::nullopt;
        }
        const double all = pairs_.angles().root_mean_square() / in_unit(1.0);
        const double left = pairs_.left().rms();
        const double right = pairs_.right().rms();
        constexpr double rounding = 0x1p-50;
        const bool is_left = left <= std::max(1.01 * right, rounding); // of equals
        const double remainder = is_left ? left : right;
        if (!(remainder < 0.01 * all) || all < rounding) {
            return std::nullopt;
        }
        const ConstantRotations found{is_left ? pairs_.left().mean() : Rotation(),
                                      is_left ? Rotation() : pairs_.right().mean()};
        return std::pair(found_rotations(found, check_.comparing.reading), remainder);
    }

    /// The figures of all angles by their names.
    [[nodiscard]] std::vector<std::pair<std::string_view, double>> figures() const {
        const operations::AngleStatistics& all = pairs_.angles();
        return {{"rms", all.root_mean_square()},
                {"mean", all.mean()},
                {"std", all.standard_deviation()},
                {"median", all.percentile(50.0)},
                {"p95", all.percentile(95.0)}};
    }

    /// The limit without a percentage, or null.
    [[nodiscard]] const PairLimit* limit_of_all() const {
        const auto found = std::ranges::find_if(limits_, &PairLimit::is_of_all);
        return found == limits_.end() ? nullptr : &*found;
    }

    [[nodiscard]] std::string in_lines(const RowsResult& result) const {
        std::string text;
        const auto add = [&text](std::string_view name, const auto& value) {
            text += fmt::format("{:9} {}\n", name, value);
        };
        const auto at = [this](std::size_t row, const std::string& key) {
            return fmt::format("{}{}", row, check_.rows.by_key ? fmt::format(" (key {})", key) : "");
        };
        const auto where = [&](const operations::WorstPair& pair) {
            return fmt::format("{} at {}", angle(pair.angle), at(pair.line, pair.keys[0]));
        };
        add("rows", pairs_.pairs());
        if (const auto* limit = limit_of_all()) {
            add("beyond", limit->beyond);
        }
        const auto& [own, other] = result.unpaired;
        const auto& [failed, failed_reference] = result.failed;
        const auto of_both = [](std::size_t rows, std::size_t reference_rows) {
            return fmt::format("{} of FILE, {} of REFERENCE", rows, reference_rows);
        };
        add("unpaired", own.rows + other.rows == 0 ? "0" : of_both(own.rows, other.rows));
        add("failed", failed_reference == 0 ? fmt::format("{}", failed) : of_both(failed, failed_reference));
        if (check_.aligned) {
            add("aligned", in_words(*check_.aligned));
        }
        if (has_pairs()) {
            add("max", where(worst()));
            for (const auto& [name, value] : figures()) {
                add(name, angle(value));
            }
            for (const PairLimit& limit : limits_) {
                if (limit.percent != 50.0 && limit.percent != 95.0 && !limit.is_of_all()) {
                    add(limit.name, angle(figure_of(limit)));
                }
            }
        }
        if (const auto found = constant()) {
            add("constant", fmt::format("{}, which leaves {}", in_words(found->first), angle(in_unit(found->second))));
        }
        std::size_t shown = 0;
        for (const operations::WorstPair& pair : pairs_.worst()) {
            if (shown++ == check_.worst) {
                break;
            }
            const std::string reference =
                pair.reference_line > 0 ? ", reference " + at(pair.reference_line, pair.keys[1]) : "";
            add(fmt::format("worst {}", shown),
                fmt::format("{}{}: {} against {}", where(pair), reference, fmt::join(pair.attitudes[0], " "),
                            fmt::join(pair.attitudes[1], " ")));
        }
        return text;
    }

    [[nodiscard]] std::string in_words(const FoundRotations& rotations) const {
        std::string sizes;
        std::string options;
        for (const FoundRotation& each : rotations) {
            sizes += (sizes.empty() ? "" : " and ") + angle(in_unit(each.size));
            options += fmt::format(" --{} '{}'", each.side, each.text);
        }
        return options.empty() ? "by nothing" : fmt::format("by {}:{}", sizes, options);
    }

    /// A figure for JSON; null without a pair.
    [[nodiscard]] JsonValue figure(double value) const {
        return has_pairs() ? JsonValue::as_written(number(value)) : JsonValue();
    }
    [[nodiscard]] JsonValue in_json(const FoundRotations& rotations) const {
        std::vector<std::pair<std::string_view, JsonValue>> object;
        for (const FoundRotation& each : rotations) {
            object.emplace_back(each.side, each.text);
            object.emplace_back(each.side == "left" ? "left_angle" : "right_angle", figure(in_unit(each.size)));
        }
        return json_object(object);
    }
    [[nodiscard]] JsonValue limits_in_json() const {
        const auto limits = mapped(limits_, [this](const PairLimit& limit) {
            return json_object({{"percent", limit.percent},
                                {"angle", limit.angle},
                                {"beyond", limit.beyond},
                                {"percentile", figure(figure_of(limit))}});
        });
        return json_array(limits).unless(limits.empty());
    }
    /// The key of a row or, from 1, of its partner.
    [[nodiscard]] JsonValue key(const operations::WorstPair& pair, std::size_t side) const {
        const std::string& text = pair.keys.at(side);
        return !check_.rows.by_key ? JsonValue() : stream::is_json_number(text) ? JsonValue::as_written(text) : text;
    }
    [[nodiscard]] JsonValue worst_in_json() const {
        const auto pairs = mapped(pairs_.worst(), [this](const operations::WorstPair& pair) {
            return json_object({{"angle", figure(pair.angle)},
                                {"line", pair.line},
                                {"reference_line", JsonValue(pair.reference_line).unless(pair.reference_line == 0)},
                                {"key", key(pair, 0)},
                                {"reference_key", key(pair, 1)},
                                {"attitude", json_array(pair.attitudes[0])},
                                {"reference", json_array(pair.attitudes[1])}});
        });
        return json_array(pairs).unless(check_.worst == 0);
    }

    [[nodiscard]] std::string in_json(const RowsResult& result, const JsonValue& verdict) const {
        const PairLimit* const of_all = limit_of_all();
        const PairLimit limit = of_all != nullptr ? *of_all : PairLimit();
        const operations::WorstPair farthest = worst();
        std::vector<std::pair<std::string_view, JsonValue>> object{
            {"rows", pairs_.pairs()},
            {"unit", std::string(unit_)},
            {"file", command_.has_values ? "argument" : command_.input},
            {"reference", JsonValue(command_.reference).unless(command_.reference.empty())},
            {"version", ROTCONV_VERSION},
            {"within", JsonValue(limit.angle).unless(of_all == nullptr)},
            {"beyond", JsonValue(limit.beyond).unless(of_all == nullptr)},
            {"first_beyond", JsonValue(limit.first_beyond).unless(limit.beyond == 0)},
            {"limits", limits_in_json()},
            {"unpaired", result.unpaired[0].rows + result.unpaired[1].rows},
            {"unpaired_file", result.unpaired[0].rows},
            {"unpaired_reference", result.unpaired[1].rows},
            {"failed", result.failed[0]},
            {"failed_reference", result.failed[1]},
            {"max", figure(farthest.angle)},
            {"max_line", JsonValue(farthest.line).unless(!has_pairs())},
            {"max_key", key(farthest, 0).unless(!has_pairs())}};
        for (const auto& [name, value] : figures()) {
            object.emplace_back(name, figure(value));
        }
        const auto found = constant();
        object.emplace_back("constant", found ? in_json(found->first) : JsonValue());
        object.emplace_back("aligned", check_.aligned ? in_json(*check_.aligned) : JsonValue());
        object.emplace_back("worst", worst_in_json());
        object.emplace_back("verdict", verdict);
        return json_line(object);
    }

    const Check& check_;
    const RowsCommand& command_;
    stream::Digits digits_;
    const operations::PairFold& pairs_;
    std::string_view unit_; ///< of angles
    const std::vector<PairLimit>& limits_ = pairs_.limits();
};

} // namespace

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

Conclusion conclusion_of(const Check& check, const RowsCommand& command, const RowsResult& result) {
    return ComparisonReport(check, command).conclude(result);
}

} // namespace rotconv::cli
