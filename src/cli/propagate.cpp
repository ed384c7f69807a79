#include <utility>
#include <vector>

#include <rotconv/propagation.hpp>

#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// The integrator of that name; without a name the best for the representation.
Integrator integrator_of(const Spec& with, const std::string& text) {
    const auto serving = mapped(
        filtered(integrators(), [&with](const auto& entry) { return can_integrate(with.name, entry.integrator); }),
        [](const IntegratorEntry& entry) { return std::pair(entry.text, entry.integrator); });
    if (text.empty()) {
        const Integrator best = PropagationSettings{}.integrator;
        return can_integrate(with.name, best) ? best : serving.front().second;
    }
    return one_of(fmt::format("integrator of {}", representation(with.name).text), text, serving);
}

Command propagate(const Given& given) {
    refuse_values(given, "propagate");
    const std::string& time_unit = given.text("--time-unit");
    operations::PropagationRows rows{.time_power = time_power_of(time_unit),
                                     .degrees = given.has("--degrees"),
                                     .conversion = attitude_settings_of(given),
                                     .continuous = given.has("--continuous"),
                                     .stop_at_error = on_error_of(given) == stream::OnError::stop};
    PropagationSettings& settings = rows.settings;
    if (given.has("--with")) {
        settings.representation = spec_of("--with", given.text("--with"), false);
    }
    require_rates("--with", settings.representation);
    settings.integrator = integrator_of(settings.representation, given.text("--integrator"));
    settings.interpolation =
        one_of<Interpolation>(given, "--interpolation", "interpolation",
                              {{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}});
    settings.renormalise = given.has("--renormalise");
    settings.substeps = count_of(given, "--substeps", 1'000'000, 1, settings.substeps);
    if (const auto initial = attitude_of(given, "--initial")) {
        settings.initial = initial->rotation;
    }
    auto numbers = operations::propagation_numbers();
    numbers.has_unit = !time_unit.empty();
    const auto propagated_as = [&rows](const Spec& spec) {
        rows.to = spec;
        return operations::propagate(rows);
    };
    return rows_command(
        given, {.list = given.text("--columns")}, numbers,
        operations::several(mapped(specs_of(given, "--to"), propagated_as)),
        {"t wx wy wz", numbers.names.size(), settings.representation.name, rows.conversion.tolerance, true});
}

} // namespace

CommandEntry propagate_command() {
    OptionSet set;
    set.add("-t,--to", "SPEC", "The representation to write: NAME[:MODIFIER]...");
    set.add("--initial", "ATTITUDE", "The attitude at the first row, as \"SPEC: NUMBERS\"");
    set.add("--with", "SET", "The representation in which to integrate (default quat)");
    set.add("--integrator", "INTEGRATOR", "rk4, or for quat also magnus4 (its default) or magnus6");
    set.add("--substeps", "N", "Integration steps from one row to the next (default 1)");
    set.add("--interpolation", "HOW", "Angular velocity between rows: linear (default), or cubic, a row late");
    set.add("--time-unit", "UNIT", "Unit of the times: s (default), ms, us or ns");
    set.add_flag("--renormalise", "Make the numbers unit, or orthogonal, again after every step");
    add_attitudes(set);
    add_continuous(set);
    add_reading(set);
    set.describe("--degrees", "Degrees, and degrees a second; :deg alone leaves radians a second");
    add_writing(set);
    add_lock_margin(set);
    return {"propagate", "Integrate angular velocities to attitudes",
            "Usage: rotconv propagate -t SPEC [OPTION]... [FILE]\n", std::move(set), propagate};
}

} // namespace rotconv::cli
