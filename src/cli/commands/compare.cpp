#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/comparison.hpp>

#include "../../stream/numbers/fmt.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../row_options.hpp"
#include "comparison_report.hpp"

namespace rotconv::cli {
namespace {

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
        std::vector<operations::PairLimit> limits = limits_of_within(unit);
        Check check{.format = written,
                    .unit = unit,
                    .least_pairs = least_pairs(),
                    .worst = count_of(worst, 1'000'000),
                    .comparing = {.reading = attitude_settings(), .per_radian = unit.per_radian}};
        if (allow_unpaired.given()) {
            check.allow_unpaired = one_of("kind of rows for --allow-unpaired", allow_unpaired, unpaired_rows);
        }
        for (const operations::PairLimit& limit : limits) {
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
    [[nodiscard]] std::vector<operations::PairLimit> limits_of_within(AngleUnitName& unit) const {
        std::vector<operations::PairLimit> all;
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
            if (const auto same = std::ranges::find(all, *percent, &operations::PairLimit::percent);
                same != all.end()) {
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
