#include <utility>

#include <rotconv/propagation.hpp>

#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

struct PropagateOptions final : RowOptions {
    PropagateOptions() {
        to.is_list = true;
        degrees.about = "Degrees, and degrees a second; :deg alone leaves radians a second";
        add("What", {&to, &initial, &with, &integrator, &substeps, &interpolation, &time_unit, &renormalise});
        add_attitudes();
        add("What", {&continuous});
        add_reading();
        add_writing();
        add("Errors", {&lock_margin});
    }

    [[nodiscard]] Command command() const override {
        refuse_values("propagate");
        operations::PropagationRows rows{.time_power = time_power_of(time_unit),
                                         .degrees = degrees.given(),
                                         .conversion = attitude_settings(),
                                         .continuous = continuous.given(),
                                         .stop_at_error = policy() == stream::OnError::stop};
        PropagationSettings& propagation = rows.settings;
        if (with.given()) {
            propagation.representation = cli::spec_of(with, false);
        }
        require_rates(with, propagation.representation);
        propagation.integrator = integrator_of(propagation.representation);
        propagation.interpolation =
            one_of("interpolation", interpolation,
                   Choices<Interpolation>{{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}});
        propagation.renormalise = renormalise.given();
        propagation.substeps = count_of(substeps, 1'000'000, 1, propagation.substeps);
        propagation.initial = attitude_of(initial).rotation;
        const auto propagated_as = [&rows](const Spec& spec) {
            rows.to = spec;
            return operations::propagate(rows);
        };
        RowsCommand made =
            rows_command(operations::several(mapped(specs_of(to, degrees.given()), propagated_as)), "t wx wy wz");
        made.subject->representation = propagation.representation.name;
        made.subject->has_steps = true;
        return made;
    }

private:
    /// That of --integrator; by default the best for the representation.
    [[nodiscard]] Integrator integrator_of(const Spec& spec) const {
        const Choices<Integrator> serving = mapped(
            filtered(integrators(), [&spec](const auto& entry) { return can_integrate(spec.name, entry.integrator); }),
            [](const IntegratorEntry& entry) { return std::pair(entry.text, entry.integrator); });
        const Integrator best = PropagationSettings{}.integrator;
        if (!integrator.given()) {
            return can_integrate(spec.name, best) ? best : serving.front().second;
        }
        return one_of(fmt::format("integrator of {}", representation(spec.name).text), integrator, integrator.text(),
                      serving, words_of(serving));
    }

    Option with{"--with", "SET", "The representation in which to integrate (default quat)"};
    Option integrator{"--integrator", "INTEGRATOR", "rk4, or for quat also magnus4 (its default) or magnus6",
                      mapped(integrators(), &IntegratorEntry::text)};
    Option substeps{"--substeps", "N", "Integration steps from one row to the next (default 1)"};
    Option interpolation{"--interpolation",
                         "HOW",
                         "Angular velocity between rows: linear (default), or cubic, a row late",
                         {"linear", "cubic"}};
    Option renormalise{"--renormalise", "", "Make the numbers unit, or orthogonal, again after every step"};
};

} // namespace

CommandEntry propagate_command() {
    return {"propagate", "Integrate angular velocities to attitudes",
            "Usage: rotconv propagate -t SPEC [OPTION]... [FILE]\n", make_options<PropagateOptions>};
}

} // namespace rotconv::cli
