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

/// The limits of --within, each an ANGLE or ANGLE@PERCENT.
std::vector<CheckLimit> limits_of(const Given& given) {
    std::vector<CheckLimit> limits;
    for (const std::string& text : given.texts("--within")) {
        const std::size_t at = text.find('@');
        if (at == 0) {
            throw Usage("--within {} has a percentage, and no angle before it", quoted(text));
        }
        CheckLimit limit{.angle = given_angle(given, "--within", text.substr(0, at))};
        if (at != std::string::npos) {
            limit.percent_text = text.substr(at + 1);
            if (stream::read_number(limit.percent_text, limit.percent) != stream::NumberError::none ||
                !(limit.percent > 0.0 && limit.percent <= 100.0)) {
                throw Usage("--within {}: {} is not a percentage above 0 and at most 100", quoted(text),
                            quoted(limit.percent_text));
            }
        }
        if (const auto same = std::ranges::find(limits, limit.percent, &CheckLimit::percent); same != limits.end()) {
            throw Usage("--within {} and {} are two limits for {} pairs", same->angle.text, limit.angle.text,
                        limit.is_of_all() ? "all" : fmt::format("{} in 100", limit.percent_text));
        }
        limits.push_back(std::move(limit));
    }
    return limits;
}

/// How many pairs a check needs: N, or N% of FILE's rows; where rows are allowed to be left out, by default half of
/// them.
LeastPairs least_pairs_of(const Given& given) {
    const std::string& text = given.text("--min-pairs");
    if (text.empty()) {
        const bool leaves_out = given.has("--allow-unpaired") || given.has("--allow-failed");
        return {.percent = leaves_out ? 50.0 : 0.0};
    }
    if (!text.ends_with('%')) {
        return {.text = text, .pairs = count_of(given, "--min-pairs", 1'000'000'000'000'000)};
    }
    double percent = 0.0;
    if (stream::read_number(text.substr(0, text.size() - 1), percent) != stream::NumberError::none ||
        !(percent > 0.0 && percent <= 100.0)) {
        throw Usage("--min-pairs {} must be a whole number from 1, or a percentage above 0 and at most 100%",
                    quoted(text));
    }
    return {.text = text, .percent = percent};
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
        operations::compare(comparison, as_they_are,
                            std::make_shared<operations::PairWatch>(1, std::vector<operations::PairLimit>())),
        pairs, [=]() -> std::variant<operations::Operation, std::string> {
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

Command compare(const Given& given) {
    const Spec from = spec_of(given, "--from");
    const Spec reference = given.has("--to") ? spec_of(given, "--to") : from;
    Check check{.format = one_of<Check::Format>(
                    given, "--format", "format of compare",
                    {{"pretty", Check::Format::pretty}, {"json", Check::Format::json}, {"csv", Check::Format::csv}}),
                .limits = limits_of(given),
                .allow_failed = given.has("--allow-failed"),
                .least_pairs = least_pairs_of(given),
                .worst = count_of(given, "--worst", 1'000'000),
                .rows = {{paired_rows_of(given)}},
                .comparing = {.reading = attitude_settings_of(given)}};
    check.unit = !check.limits.empty()    ? check.limits[0].angle.unit
                 : given.has("--degrees") ? in_degrees
                                          : AngleUnitName();
    if (given.has("--allow-unpaired")) {
        check.allow_unpaired = one_of<std::array<bool, 2>>(
            "kind of rows for --allow-unpaired", given.text("--allow-unpaired"),
            {{"file", {true, false}}, {"reference", {false, true}}, {"both", {true, true}}});
    }
    const bool as_rows = check.format == Check::Format::csv;
    ComparisonSettings& comparing = check.comparing;
    comparing.per_radian = check.unit.per_radian;
    std::vector<operations::PairLimit> limits;
    for (const CheckLimit& limit : check.limits) {
        limits.push_back({.angle = limit.angle.in(check.unit), .percent = limit.percent});
        comparing.within = limit.is_of_all() ? limits.back().angle : comparing.within;
    }
    const Comparison comparison(from, reference, comparing);

    operations::ComparisonRows& rows = check.rows;
    rows.as_numbers = !as_rows;
    rows.delta = count_of(given, "--delta", 1'000'000);
    rows.unit = check.unit.text;
    messages::Subject subject = rows.paired ? messages::subject_of(from, comparing.reading.tolerance)
                                            : messages::subject_of_two(from, reference, comparing.reading.tolerance);
    check.watch = std::make_shared<operations::PairWatch>(std::max<std::size_t>(check.worst, 1), std::move(limits));
    RowsCommand command = rows_command(given, columns_of_file(given), operations::pair_numbers(from, reference, rows),
                                       operations::compare(comparison, rows, check.watch), std::move(subject));
    command.options.append = as_rows;
    command.options.format = as_rows ? stream::Format::csv : stream::Format::result;
    command.allow_failed = check.allow_failed;
    if (rows.paired) {
        pair(given, command, operations::attitude_numbers(reference, rows.by_key),
             messages::subject_of(reference, comparing.reading.tolerance));
    }
    const bool in_degrees_alone = from.unit == AngleUnit::degrees || reference.unit == AngleUnit::degrees;
    for (const std::string& text : given.texts("--within")) { // a bare one is in radians, whatever FILE is in
        const auto at = std::min(text.find('@'), text.size());
        const GivenAngle angle = given_angle(given, "--within", text.substr(0, at));
        if (in_degrees_alone && angle.is_bare && angle.unit.text == "rad" && std::isfinite(angle.value)) {
            command.notes.push_back(
                {.kind = stream::Note::Kind::limit,
                 .text =
                     fmt::format("--within {0} is in radians, and the angles that are read are in degrees: --within "
                                 "{1}deg{2}, or {1}rad{2}",
                                 text, text.substr(0, at), text.substr(at))});
        }
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
    set.add("--within", "ANGLE", "The largest angle that passes, such as 0.3deg; 0.3deg@95: of 95 in 100");
    set.let_repeat("--within");
    set.add("--allow-unpaired", "WHOSE", "Rows without a partner pass: file, reference or both");
    set.add_flag("--allow-failed", "Rows without an attitude pass, with --on-error skip or nan");
    set.add("--min-pairs", "N", "Pairs that must be compared, or N% of the rows (with --allow-...: 50%)");
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
