#include "kinematics.hpp"

#include <algorithm>
#include <utility>

#include <CLI/CLI.hpp>

#include <rotconv/propagation.hpp>
#include <rotconv/rates.hpp>

#include "../stream/differences.hpp"
#include "../stream/fmt.hpp"

namespace rotconv::cli {
namespace {

constexpr double default_condition = 1e3;

void refuse_values(const Operands& operands, std::string_view command) {
    if (!operands.values.empty()) {
        throw Usage(fmt::format("{} reads rows, not arguments: {}", command, messages::quoted(operands.values[0])));
    }
}

void require_rates(std::string_view option, const Spec& spec) {
    if (!has_rates(spec.name)) {
        throw Usage(fmt::format("{} {}: its axis has no rate at the identity; rotvec has", option,
                                representation(spec.name).text));
    }
}

/// The integrator of that name; without a name the best for the set.
Integrator integrator_of(const Spec& set, const std::string& text) {
    std::vector<std::pair<std::string_view, Integrator>> serving;
    for (const IntegratorEntry& entry : integrators()) {
        if (can_integrate(set.name, entry.integrator)) {
            serving.emplace_back(entry.text, entry.integrator);
        }
    }
    if (text.empty()) {
        const Integrator best = PropagationSettings{}.integrator;
        return can_integrate(set.name, best) ? best : serving.front().second;
    }
    return choose(fmt::format("integrator of {}", representation(set.name).text), text, serving);
}

void define_time_unit(CLI::App& app, RawOptions& texts) {
    app.add_option("--time-unit", texts.time_unit, "Unit of the times: s (default), ms, us or ns")->type_name("UNIT");
}

int time_power_of(const RawOptions& texts) {
    return choose<int>("time unit", texts.time_unit, {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}});
}

Frame frame_of(const RawOptions& texts) {
    return choose<Frame>("frame", texts.frame, {{"body", Frame::body}, {"reference", Frame::reference}});
}

void explain_degrees(CLI::App& app) {
    app.get_option("--degrees")->description("Degrees, and degrees a second; :deg alone leaves radians a second");
}

RowsCommand differences_command(const RawOptions& texts, const Operands& operands) {
    if (texts.inverse) {
        throw Usage("--inverse and --differences exclude each other");
    }
    refuse_values(operands, "rates --differences");
    const Spec spec = spec_of("--from", texts.from, texts.degrees);
    const ConversionSettings settings = settings_of(texts);
    auto operation = stream::differences_operation({.spec = spec,
                                                    .time_power = time_power_of(texts),
                                                    .degrees = texts.degrees,
                                                    .frame = frame_of(texts),
                                                    .tolerance = settings.tolerance,
                                                    .sensitivity = settings.sensitivity});
    messages::Subject about{fmt::format("t with {}", representation(spec.name).text), operation.inputs, spec.name,
                            settings.tolerance};
    return rows_command(texts, std::move(operation), std::move(about), operands);
}

} // namespace

void define_rates(CLI::App& app, RawOptions& texts) {
    define_from(app, texts);
    app.add_option("--frame", texts.frame, "Axes of the angular velocity: body (default) or reference")
        ->type_name("FRAME");
    app.add_flag("--inverse", texts.inverse, "Read the numbers and their rates, print the angular velocity");
    app.add_flag("--differences", texts.differences,
                 "Read times and attitudes, print the angular velocity between rows");
    define_time_unit(app, texts);
    define_input(app, texts);
    explain_degrees(app);
    define_output(app, texts);
}

void define_propagate(CLI::App& app, RawOptions& texts) {
    define_to(app, texts);
    app.add_option("--initial", texts.initial, "The attitude at the first row, as \"SPEC: NUMBERS\"")
        ->type_name("ATTITUDE");
    app.add_option("--with", texts.with, "The representation in which to integrate (default quat)")->type_name("SET");
    app.add_option("--integrator", texts.integrator, "rk4, or for quat also magnus4 (its default) or magnus6")
        ->type_name("INTEGRATOR");
    app.add_option("--substeps", texts.substeps, "Integration steps from one row to the next (default 1)")
        ->type_name("N");
    app.add_option("--interpolation", texts.interpolation,
                   "Angular velocity between rows: linear (default), or cubic, a row late")
        ->type_name("HOW");
    define_time_unit(app, texts);
    app.add_flag("--renormalise", texts.renormalise, "Make the numbers unit, or orthogonal, again after every step");
    define_attitudes(app, texts);
    define_input(app, texts);
    explain_degrees(app);
    define_output(app, texts);
    define_lock_margin(app, texts);
}

void define_survey(CLI::App& app, RawOptions& texts) {
    define_from(app, texts);
    app.add_option("--condition", texts.condition, "How much a representation may enlarge a small turn (default 1e3)")
        ->type_name("LIMIT");
    begin_group(app, "Output");
    app.add_option("--format", texts.format, "pretty (default), a table, or json")->type_name("FORMAT");
    define_input(app, texts);
}

RowsCommand rates_command(const RawOptions& texts, const Operands& operands) {
    if (texts.differences) {
        return differences_command(texts, operands);
    }
    const Spec spec = spec_of("--from", texts.from, texts.degrees);
    require_rates("--from", spec);
    const ConversionSettings shared = settings_of(texts);
    const RateSettings settings{
        .inverse = texts.inverse, .degrees = texts.degrees, .frame = frame_of(texts), .tolerance = shared.tolerance};
    auto operation = stream::rates_operation(spec, settings, shared.sensitivity);
    const std::string subject =
        fmt::format("{} with {}", representation(spec.name).text, settings.inverse ? "its rates" : "wx wy wz");
    messages::Subject about{subject, operation.inputs, spec.name, settings.tolerance};
    return rows_command(texts, std::move(operation), std::move(about), operands);
}

RowsCommand propagate_command(const RawOptions& texts, const Operands& operands) {
    refuse_values(operands, "propagate");
    const Spec to = spec_of("--to", texts.to, texts.degrees);
    const Spec set = spec_of("--with", texts.with, false);
    require_rates("--with", set);
    const ConversionSettings settings = settings_of(texts);
    stream::PropagationRows rows;
    rows.time_power = time_power_of(texts);
    rows.degrees = texts.degrees;
    rows.to = to;
    rows.conversion = settings;
    rows.stop_at_error = on_error_of(texts) == stream::OnError::stop;
    rows.settings.set = set;
    rows.settings.integrator = integrator_of(set, texts.integrator);
    rows.settings.interpolation = choose<Interpolation>(
        "interpolation", texts.interpolation, {{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}});
    rows.settings.renormalise = texts.renormalise;
    if (!texts.substeps.empty()) {
        rows.settings.substeps = static_cast<std::size_t>(count_of("--substeps", texts.substeps, 1'000'000));
    }
    if (!texts.initial.empty()) {
        rows.settings.initial = attitude_of("--initial", texts.initial, texts.degrees, settings.tolerance).rotation;
    }
    auto operation = stream::propagation_operation(rows);
    if (texts.continuous) {
        operation = stream::continuous(std::move(operation));
    }
    messages::Subject about{"t wx wy wz", operation.inputs, set.name, settings.tolerance};
    return rows_command(texts, std::move(operation), std::move(about), operands);
}

SurveyCommand survey_command(const RawOptions& texts, const Operands& operands) {
    refuse_values(operands, "survey");
    const Spec from = spec_of("--from", texts.from, texts.degrees);
    const double tolerance = settings_of(texts).tolerance;
    RawOptions input = texts;
    input.format.clear(); // that of the survey
    const auto survey = std::make_shared<Survey>();
    auto operation = stream::reading_operation(
        from, tolerance, [survey](const Rotation& rotation, std::size_t line) { survey->add(rotation, line); });
    return {.rows = rows_command(input, std::move(operation), messages::subject_of(from, tolerance), operands),
            .survey = survey,
            .condition = amount_of("--condition", texts.condition, default_condition, true),
            .json = choose<bool>("format of survey", texts.format.empty() ? "pretty" : texts.format,
                                 {{"pretty", false}, {"json", true}})};
}

} // namespace rotconv::cli
