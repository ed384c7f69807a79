#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/comparison.hpp>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "comparison_report.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// "50,95.5" with names such as "p95.5".
std::vector<std::pair<std::string, double>> percentiles_of(const std::string& list) {
    if (list.empty()) {
        return {{"median", 50.0}, {"p95", 95.0}};
    }
    std::vector<std::pair<std::string, double>> percentiles;
    for (const std::string_view text : items_of(list)) {
        double value = 0.0;
        if (stream::read_number(text, value) != stream::NumberError::none || !(value > 0.0 && value <= 100.0)) {
            throw Usage("--percentiles {}: {} is not above 0 and at most 100", quoted(list), quoted(text));
        }
        if (std::ranges::count(percentiles, value, &std::pair<std::string, double>::second) > 0) {
            throw Usage("--percentiles {} has {} twice", quoted(list), quoted(text));
        }
        percentiles.emplace_back(fmt::format("p{}", value), value);
    }
    return percentiles;
}

/// Has the command find the turns of --align first.
/// @return where they will be
std::shared_ptr<TurnOptions> align(const Given& given, RowsCommand& command, const Comparison& comparison,
                                   const operations::ComparisonRows& rows,
                                   const std::shared_ptr<operations::PairWatch>& watch) {
    const auto side = one_of<AlignedSide>("side of --align", given.text("--align"),
                                          {{"reference", AlignedSide::reference},
                                           {"body", AlignedSide::body},
                                           {"both", AlignedSide::both},
                                           {"yaw", AlignedSide::yaw},
                                           {"first", AlignedSide::first}});
    if (command.has_values || command.input == "-" || command.reference == "-") {
        throw Usage("--align reads its input twice: give FILEs, not VALUEs or stdin");
    }
    operations::ComparisonRows as_they_are = rows;
    as_they_are.as_numbers = true;
    as_they_are.delta = 0;
    const auto pairs = std::make_shared<operations::PairStatistics>();
    pairs->alignment.emplace(side);
    auto found = std::make_shared<TurnOptions>();
    command.first_pass = {
        operations::compare(comparison, as_they_are, std::make_shared<operations::PairWatch>(1, Limit().angle)), pairs,
        [=]() -> std::variant<operations::Operation, std::string> {
            const auto turns = pairs->alignment->turns();
            if (!turns) {
                return "the pairs do not determine the turn of --align";
            }
            ComparisonSettings turned = comparison.settings();
            *found = turn_options(*turns, turned.reading);
            turned.reading.left.reset();
            turned.reading.right.reset();
            for (const TurnOption& turn : *found) { // as the options have it
                (turn.side == "left" ? turned.reading.left : turned.reading.right) = turn.turn;
            }
            return operations::compare(Comparison(comparison.from(), comparison.reference(), turned), rows, watch);
        }};
    return found;
}

/// A bare limit is in radians, whatever FILE is in.
void note_unit(const Given& given, std::string_view option, double limit, RowsCommand& command) {
    if (const std::string& text = given.text(option); stream::is_number(text) && std::isfinite(limit)) {
        command.notes.push_back(
            {.kind = stream::Note::Kind::limit,
             .text = fmt::format("{0} {1} is in radians, and the angles that are read are in degrees: {0} {1}deg, or "
                                 "{1}rad",
                                 option, text)});
    }
}

Command compare(const Given& given) {
    const Spec from = spec_of(given, "--from");
    const Spec reference = given.has("--to") ? spec_of(given, "--to") : from;
    const bool degrees = given.has("--degrees");
    Check check{.format = one_of<Check::Format>(
                    given, "--format", "format of compare",
                    {{"pretty", Check::Format::pretty}, {"json", Check::Format::json}, {"csv", Check::Format::csv}}),
                .within = limit_of(given, "--within", degrees),
                .within_p95 = limit_of(given, "--within-p95", degrees),
                .allow_failed = given.has("--allow-failed"),
                .percentiles = percentiles_of(given.text("--percentiles")),
                .worst = count_of(given, "--worst", 1'000'000),
                .rows = {{paired_rows_of(given)}},
                .comparing = {.reading = attitude_settings_of(given),
                              .unit = degrees ? AngleUnit::degrees : AngleUnit::radians}};
    if (given.has("--allow-unpaired")) {
        check.allow_unpaired = one_of<std::array<bool, 2>>(
            "kind of rows for --allow-unpaired", given.text("--allow-unpaired"),
            {{"file", {true, false}}, {"reference", {false, true}}, {"both", {true, true}}});
    }
    const bool as_rows = check.format == Check::Format::csv;
    ComparisonSettings& comparing = check.comparing;
    comparing.within = check.within.angle;
    const Comparison comparison(from, reference, comparing);

    operations::ComparisonRows& rows = check.rows;
    rows.as_numbers = !as_rows;
    rows.delta = count_of(given, "--delta", 1'000'000);
    messages::Subject subject = rows.paired ? messages::subject_of(from, comparing.reading.tolerance)
                                            : messages::subject_of_two(from, reference, comparing.reading.tolerance);
    check.watch =
        std::make_shared<operations::PairWatch>(std::max<std::size_t>(check.worst, 1), check.within_p95.angle);
    RowsCommand command = rows_command(given, columns_of_file(given), operations::pair_numbers(from, reference, rows),
                                       operations::compare(comparison, rows, check.watch), std::move(subject));
    command.options.append = as_rows;
    command.options.format = as_rows ? stream::Format::csv : stream::Format::result;
    command.allow_failed = check.allow_failed;
    if (rows.paired) {
        pair(given, command, operations::attitude_numbers(reference, rows.by_key),
             messages::subject_of(reference, comparing.reading.tolerance));
    }
    if (comparing.unit == AngleUnit::radians &&
        (from.unit == AngleUnit::degrees || reference.unit == AngleUnit::degrees)) {
        note_unit(given, "--within", check.within.angle, command);
        note_unit(given, "--within-p95", check.within_p95.angle, command);
    }
    check.digits = command.options.digits;
    check.file = command.has_values ? "argument" : command.input;
    check.reference = command.reference;
    check.aligned = given.has("--align") ? align(given, command, comparison, rows, check.watch) : nullptr;
    command.conclusion = comparison_conclusion(std::move(check));
    return command;
}

} // namespace

CommandEntry compare_command() {
    OptionSet set;
    set.begin_group("What");
    set.add("-f,--from", "SPEC", "The representation to read: NAME[:MODIFIER]...");
    set.add("-t,--to", "SPEC", "The representation of the reference (default: that of --from)");
    set.add("--align", "SIDE", "Turn FILE by the best constant: reference, body, both, yaw, or first");
    set.add("--delta", "N", "Compare the turns from each pair to the N-th after it");
    add_attitudes(set);
    set.begin_group("Check");
    set.add("--within", "ANGLE", "The largest angle that passes, such as 0.3deg, 5mrad or 0.1rad");
    set.add("--within-p95", "ANGLE", "The angle that 95 in 100 pairs must not exceed");
    set.add("--allow-unpaired", "WHOSE", "Rows without a partner pass: file, reference or both");
    set.add_flag("--allow-failed", "Rows without an attitude pass, with --on-error skip or nan");
    add_pairing(set);
    set.add_flag("--interpolate", "Take the reference at FILE's key, between two rows --key-within apart");
    add_reading(set);
    add_writing(set);
    set.describe("--reference-axes", "Other reference axes of FILE's attitudes, such as ned:enu");
    set.describe("--body-axes", "Other body axes of FILE's attitudes, such as frd:flu, by their names");
    set.describe("--left", "Turn the attitudes R of FILE: compare L R; L as \"SPEC: NUMBERS\"");
    set.describe("--right", "Turn the attitudes R of FILE: compare R S; S as \"SPEC: NUMBERS\"");
    set.describe("--format", "pretty (default), json, or csv: every pair with its angle");
    set.begin_group("Output");
    set.add("--worst", "N", "Show the N pairs that differ most");
    set.add("--percentiles", "LIST", "Of the angles (default: the median and 95)");
    add_lock_margin(set);
    return {"compare",
            "Check attitudes against a reference, by the angles between them",
            "Usage: rotconv compare -f SPEC [-t SPEC] [OPTION]... FILE REFERENCE\n"
            "       rotconv compare -f SPEC [-t SPEC] [OPTION]... [FILE]\n"
            "       rotconv compare -f SPEC [-t SPEC] [OPTION]... VALUE...\n",
            std::move(set),
            compare,
            2};
}

} // namespace rotconv::cli
