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

/// The report and the verdict.
class ComparisonReport {
public:
    explicit ComparisonReport(const Check& check) : check_(check), pairs_(*check.pairs), unit_(check_.unit.text) {
        if (check_.format == Check::Format::pretty && check_.digits.shortest()) {
            check_.digits.significant = 6;
        }
    }

    [[nodiscard]] Answer answer(const RowsResult& result) const {
        const std::size_t pairs = pairs_.pairs();
        const std::size_t alone = result.unpaired[0].rows + (result.keys.any_pair ? 0 : result.unpaired[1].rows);
        if (check_.rows.by_key && 2 * alone > result.rows) {
            print_error(messages::few_keys_met(result.keys));
        } else if (pairs == 0 && result.code == ExitCode::done) {
            print_error(check_.rows.delta > 0 && result.answered > 0
                            ? "no pair has one after it at the distance of --delta"
                            : std::string(messages::nothing_read));
        }
        const std::string fault = fault_of(result);
        const std::string verdict = check_.limits.empty() ? "not checked: no --within"
                                    : fault.empty()       ? "pass: " + figures_of_limits()
                                                          : "fail: " + fault;
        if (check_.format == Check::Format::csv && pairs > 0) { // of which the rows do not tell
            for (std::size_t i = 0; i < check_.limits.size(); ++i) {
                if (const std::string found = check_.limits[i].is_of_all() ? "" : fault_of_limit(i); !found.empty()) {
                    print_error(found);
                }
            }
        }
        const bool is_untold = check_.limits.empty() || check_.format == Check::Format::csv; // by the verdict
        if (const std::string found = fault_of_count(result); is_untold && pairs > 0 && !found.empty()) {
            print_error(found);
        }
        return {.text = check_.format == Check::Format::csv ? ""
                        : check_.format == Check::Format::json
                            ? in_json(result, check_.limits.empty() ? JsonValue() : verdict)
                            : in_lines(result, verdict),
                .holds = fault.empty()};
    }

private:
    [[nodiscard]] std::string number(double value) const {
        stream::Buffer text;
        stream::append_number(text, value, check_.digits);
        return fmt::to_string(text);
    }
    /// The angle in the unit of the report.
    [[nodiscard]] double in_unit(double radians) const { return check_.unit.per_radian * radians; }
    /// The angle with its unit.
    [[nodiscard]] std::string angle(double value) const { return fmt::format("{} {}", number(value), unit_); }

    /// The name of a limit's figure.
    [[nodiscard]] static std::string name_of(const CheckLimit& limit) {
        return limit.is_of_all() ? "max" : "p" + limit.percent_text;
    }
    /// Its value, if there is a pair.
    [[nodiscard]] double figure_of(const operations::PairLimit& limit) const {
        if (limit.percent == 100.0) {
            return pairs_.worst().begin()->angle;
        }
        const double estimate = pairs_.angles().percentile(limit.percent); // which must not belie the count
        return limit.holds(pairs_.pairs()) ? std::min(estimate, limit.angle) : std::max(estimate, limit.angle);
    }
    /// "p95 0.02 deg".
    [[nodiscard]] std::string named_figure(std::size_t index) const {
        return fmt::format("{} {}", name_of(check_.limits[index]), angle(figure_of(pairs_.limits()[index])));
    }
    /// A limit as it is given, or in the unit of the figures.
    [[nodiscard]] std::string text_of(const CheckLimit& limit) const {
        return limit.angle.unit.text == unit_ ? limit.angle.text : angle(limit.angle.in(check_.unit));
    }
    /// What pairs within all limits are like.
    [[nodiscard]] std::string figures_of_limits() const {
        std::string text;
        for (std::size_t i = 0; i < check_.limits.size(); ++i) {
            text += fmt::format("{}, limit {}, ", named_figure(i), text_of(check_.limits[i]));
        }
        return text + counted(pairs_.pairs(), "pair");
    }
    /// Why a limit does not hold; empty if it does.
    [[nodiscard]] std::string fault_of_limit(std::size_t index) const {
        const operations::PairLimit& counts = pairs_.limits()[index];
        return counts.holds(pairs_.pairs())
                   ? std::string()
                   : fmt::format("{} is beyond {}, {} of {}, first at line {}", named_figure(index),
                                 text_of(check_.limits[index]), counts.beyond, counted(pairs_.pairs(), "pair"),
                                 counts.first_beyond);
    }
    /// Why too few pairs were compared; empty if there are enough.
    [[nodiscard]] std::string fault_of_count(const RowsResult& result) const {
        const LeastPairs& least = check_.least_pairs;
        const auto pairs = static_cast<double>(result.answered);
        const auto rows = static_cast<double>(result.rows);
        if (result.answered >= least.pairs && 100.0 * pairs >= least.percent * rows * (1.0 - 0x1p-50)) {
            return {};
        }
        return fmt::format("{} of {} compared (--min-pairs{})", result.answered,
                           least.percent > 0.0 ? "FILE's " + counted(result.rows, "row") : counted(least.pairs, "pair"),
                           least.text.empty() ? ": at least half, unless it says otherwise" : " " + least.text);
    }

    /// What does not hold; empty if all does.
    [[nodiscard]] std::string fault_of(const RowsResult& result) const {
        std::vector<std::string> faults;
        const std::size_t pairs = pairs_.pairs();
        if (pairs == 0) {
            faults.emplace_back("no pairs");
        }
        for (std::size_t i = 0; i < check_.limits.size(); ++i) {
            faults.push_back(fault_of_limit(i));
        }
        faults.push_back(pairs == 0 ? "" : fault_of_count(result));
        for (const std::size_t side : {0U, 1U}) {
            const std::size_t rows = result.unpaired.at(side).rows;
            if (rows > 0 && !check_.allow_unpaired.at(side)) {
                faults.push_back(
                    fmt::format("{} of {} unpaired", counted(rows, "row"), side == 0 ? "FILE" : "REFERENCE"));
            }
        }
        if (result.failed > 0 && !check_.allow_failed) {
            faults.push_back(counted(result.failed, "row") + " failed");
        } else if (result.code == ExitCode::completed_with_failures) {
            faults.emplace_back("--strict met a diagnostic");
        }
        std::erase(faults, "");
        return fmt::format("{}", fmt::join(faults, "; "));
    }

    /// The turns on one side that leave less than a hundredth, if there are such, and what they leave, in radians.
    [[nodiscard]] std::optional<std::pair<TurnOptions, double>> constant() const {
        if (check_.rows.delta > 0 || pairs_.pairs() < 2) {
            return std::nullopt;
        }
        const double all = pairs_.angles().root_mean_square() / in_unit(1.0);
        const double left = pairs_.left().rms();
        const double right = pairs_.right().rms();
        constexpr double rounding = 0x1p-50;
        const bool is_left = left <= std::max(1.01 * right, rounding); // of equals
        const double rest = is_left ? left : right;
        if (!(rest < 0.01 * all) || all < rounding) {
            return std::nullopt;
        }
        const ConstantTurns turns =
            is_left ? ConstantTurns{pairs_.left().mean(), {}} : ConstantTurns{{}, pairs_.right().mean()};
        return std::pair(turn_options(turns, check_.comparing.reading), rest);
    }

    /// The figures of all angles by their names.
    [[nodiscard]] std::vector<std::pair<std::string, double>> figures() const {
        std::vector<std::pair<std::string, double>> all{{"rms", pairs_.angles().root_mean_square()},
                                                        {"mean", pairs_.angles().mean()},
                                                        {"std", pairs_.angles().standard_deviation()}};
        for (const auto& [name, percent] : {std::pair("median", 50.0), std::pair("p95", 95.0)}) {
            all.emplace_back(name, pairs_.angles().percentile(percent));
        }
        return all;
    }

    [[nodiscard]] std::string in_lines(const RowsResult& result, const std::string& verdict) const {
        const auto line = [](std::string_view name, const auto& value) {
            return fmt::format("{:9} {}\n", name, value);
        };
        std::string text = line("rows", pairs_.pairs());
        const std::size_t of_all = index_of_all();
        if (of_all < check_.limits.size()) {
            text += line("beyond", pairs_.limits()[of_all].beyond);
        }
        const auto& [own, other] = result.unpaired;
        text +=
            line("unpaired",
                 own.rows + other.rows == 0 ? "0" : fmt::format("{} of FILE, {} of REFERENCE", own.rows, other.rows));
        text += line("failed", result.failed);
        const auto at = [this](std::size_t row, const std::string& key) {
            return fmt::format("{}{}", row, check_.rows.by_key ? fmt::format(" (key {})", key) : "");
        };
        const auto where = [&](const operations::WorstPair& pair) {
            return fmt::format("{} at {}", angle(pair.angle), at(pair.line, pair.keys[0]));
        };
        if (check_.aligned) {
            text += line("aligned", in_words(*check_.aligned));
        }
        if (pairs_.pairs() > 0) {
            text += line("max", where(*pairs_.worst().begin()));
            for (const auto& [name, value] : figures()) {
                text += line(name, angle(value));
            }
            for (std::size_t i = 0; i < check_.limits.size(); ++i) {
                const CheckLimit& limit = check_.limits[i];
                if (limit.percent != 50.0 && limit.percent != 95.0 && !limit.is_of_all()) {
                    text += line(name_of(limit), angle(figure_of(pairs_.limits()[i])));
                }
            }
        }
        if (const auto found = constant()) {
            text += line("constant",
                         fmt::format("{}, which leaves {}", in_words(found->first), angle(in_unit(found->second))));
        }
        std::size_t shown = 0;
        for (const operations::WorstPair& pair : pairs_.worst()) {
            if (shown++ == check_.worst) {
                break;
            }
            const std::string reference =
                pair.reference_line > 0 ? ", reference " + at(pair.reference_line, pair.keys[1]) : "";
            text += line(fmt::format("worst {}", shown),
                         fmt::format("{}{}: {} against {}", where(pair), reference, fmt::join(pair.attitudes[0], " "),
                                     fmt::join(pair.attitudes[1], " ")));
        }
        return text + verdict + "\n";
    }

    [[nodiscard]] std::string in_words(const TurnOptions& turns) const {
        std::string sizes;
        std::string options;
        for (const TurnOption& turn : turns) {
            sizes += (sizes.empty() ? "" : " and ") + angle(in_unit(turn.size));
            options += fmt::format(" --{} '{}'", turn.side, turn.text);
        }
        return options.empty() ? "by nothing" : fmt::format("by {}:{}", sizes, options);
    }
    [[nodiscard]] JsonValue in_json(const TurnOptions& turns) const {
        std::vector<std::pair<std::string_view, JsonValue>> object;
        for (const TurnOption& turn : turns) {
            object.emplace_back(turn.side, turn.text);
            object.emplace_back(turn.side == "left" ? "left_angle" : "right_angle",
                                JsonValue::as_written(number(in_unit(turn.size))));
        }
        return json_object(object);
    }
    /// The limit without a percentage, or the count of limits.
    [[nodiscard]] std::size_t index_of_all() const {
        return static_cast<std::size_t>(std::ranges::find_if(check_.limits, &CheckLimit::is_of_all) -
                                        check_.limits.begin());
    }
    [[nodiscard]] JsonValue limits_in_json() const {
        std::vector<std::string> limits;
        for (const operations::PairLimit& limit : pairs_.limits()) {
            const bool has_pairs = pairs_.pairs() > 0;
            limits.push_back(
                json_object({{"percent", limit.percent},
                             {"angle", limit.angle},
                             {"beyond", limit.beyond},
                             {"percentile", has_pairs ? JsonValue::as_written(number(figure_of(limit))) : JsonValue()}})
                    .text);
        }
        return limits.empty() ? JsonValue() : JsonValue::as_written(fmt::format("[{}]", fmt::join(limits, ", ")));
    }

    /// The key of a row or, from 1, of its partner.
    [[nodiscard]] JsonValue key(const operations::WorstPair& pair, std::size_t side) const {
        const std::string& text = pair.keys.at(side);
        return !check_.rows.by_key ? JsonValue() : stream::is_json_number(text) ? JsonValue::as_written(text) : text;
    }

    [[nodiscard]] JsonValue worst_in_json() const {
        std::vector<std::string> pairs;
        for (const operations::WorstPair& pair : pairs_.worst()) {
            const auto list = [](const auto& items) {
                return JsonValue::as_written(fmt::format("[{}]", fmt::join(items, ", ")));
            };
            pairs.push_back(
                json_object({{"angle", JsonValue::as_written(number(pair.angle))},
                             {"line", pair.line},
                             {"reference_line", pair.reference_line > 0 ? JsonValue(pair.reference_line) : JsonValue()},
                             {"key", key(pair, 0)},
                             {"reference_key", key(pair, 1)},
                             {"attitude", list(pair.attitudes[0])},
                             {"reference", list(pair.attitudes[1])}})
                    .text);
        }
        return check_.worst == 0 ? JsonValue() : JsonValue::as_written(fmt::format("[{}]", fmt::join(pairs, ", ")));
    }

    [[nodiscard]] std::string in_json(const RowsResult& result, const JsonValue& verdict) const {
        const bool has_pairs = pairs_.pairs() > 0;
        const auto value_if = [](bool is_there, JsonValue value) { return is_there ? std::move(value) : JsonValue(); };
        const auto figure = [&](double value) { return value_if(has_pairs, JsonValue::as_written(number(value))); };
        const std::size_t of_all = index_of_all();
        const bool is_limited = of_all < check_.limits.size();
        const operations::PairLimit limit = is_limited ? pairs_.limits()[of_all] : operations::PairLimit();
        const operations::WorstPair worst = has_pairs ? *pairs_.worst().begin() : operations::WorstPair();
        std::vector<std::pair<std::string_view, JsonValue>> object{
            {"rows", pairs_.pairs()},
            {"unit", std::string(unit_)},
            {"file", check_.file},
            {"reference", value_if(!check_.reference.empty(), check_.reference)},
            {"version", ROTCONV_VERSION},
            {"within", value_if(is_limited, limit.angle)},
            {"beyond", value_if(is_limited, limit.beyond)},
            {"first_beyond", value_if(limit.beyond > 0, limit.first_beyond)},
            {"limits", limits_in_json()},
            {"unpaired", result.unpaired[0].rows + result.unpaired[1].rows},
            {"unpaired_file", result.unpaired[0].rows},
            {"unpaired_reference", result.unpaired[1].rows},
            {"failed", result.failed},
            {"max", figure(worst.angle)},
            {"max_line", value_if(has_pairs, worst.line)},
            {"max_key", value_if(has_pairs, key(worst, 0))}};
        const auto all = figures();
        for (const auto& [name, value] : all) {
            object.emplace_back(name, figure(value));
        }
        const auto found = constant();
        object.emplace_back("constant", found ? in_json(found->first) : JsonValue());
        object.emplace_back("aligned", check_.aligned ? in_json(*check_.aligned) : JsonValue());
        object.emplace_back("worst", worst_in_json());
        object.emplace_back("verdict", verdict);
        return json_line(object);
    }

    Check check_;
    const operations::PairFold& pairs_;
    std::string_view unit_; ///< of angles
};

} // namespace

TurnOptions turn_options(const ConstantTurns& found, const ConversionSettings& given) {
    TurnOptions options;
    const auto add = [&](std::string_view side, const Rotation& turn, const FixedRotation& all) {
        if (all.rotation.vector_length() > 0.0) {
            const Eigen::Quaterniond q = quaternion::from_rotation(all.rotation);
            const std::array numbers{q.w() + 0.0, q.x() + 0.0, q.y() + 0.0, q.z() + 0.0}; // no -0
            options.push_back({side, fmt::format("quat: {}", fmt::join(numbers, " ")),
                               FixedRotation::of_numbers(Spec{}, numbers), axis_angle::from_rotation(turn).angle});
        }
    };
    const FixedRotation none{Rotation{}};
    add("left", found.left, FixedRotation(found.left) * given.left.value_or(none));
    add("right", found.right, given.right.value_or(none) * FixedRotation(found.right));
    return options;
}

Answer answer_of(const Check& check, const RowsResult& result) { return ComparisonReport(check).answer(result); }

} // namespace rotconv::cli
