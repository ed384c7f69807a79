#include <utility>
#include <vector>

#include <rotconv/propagation.hpp>

#include "../stream/fmt.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// The integrator of that name; without a name the best for the representation.
Integrator integrator_of(const Spec& with, const std::string& text) {
    std::vector<std::pair<std::string_view, Integrator>> serving;
    for (const IntegratorEntry& entry : integrators()) {
        if (can_integrate(with.name, entry.integrator)) {
            serving.emplace_back(entry.text, entry.integrator);
        }
    }
    if (text.empty()) {
        const Integrator best = PropagationSettings{}.integrator;
        return can_integrate(with.name, best) ? best : serving.front().second;
    }
    return one_of(fmt::format("integrator of {}", representation(with.name).text), text, serving);
}

class PropagateOptions final : public RowOptions {
public:
    PropagateOptions() {
        set.begin_group("What");
        set.add("-t,--to", to_, "SPEC", "The representation to write: NAME[:MODIFIER]...");
        set.add("--initial", initial_, "ATTITUDE", "The attitude at the first row, as \"SPEC: NUMBERS\"");
        set.add("--with", with_, "SET", "The representation in which to integrate (default quat)");
        set.add("--integrator", integrator_, "INTEGRATOR", "rk4, or for quat also magnus4 (its default) or magnus6");
        set.add("--substeps", substeps_, "N", "Integration steps from one row to the next (default 1)");
        set.add("--interpolation", interpolation_, "HOW",
                "Angular velocity between rows: linear (default), or cubic, a row late");
        set.add("--time-unit", time_unit_, "UNIT", "Unit of the times: s (default), ms, us or ns");
        set.add("--renormalise", renormalise_, "Make the numbers unit, or orthogonal, again after every step");
        attitudes_.add_to(set);
        add_reading();
        set.describe("--degrees", "Degrees, and degrees a second; :deg alone leaves radians a second");
        add_writing();
        attitudes_.add_lock_margin_to(set);
    }

    [[nodiscard]] Command command(const Operands& operands) const override {
        refuse_values(operands, "propagate");
        operations::PropagationRows rows{.time_power = time_power_of(time_unit_),
                                         .degrees = degrees,
                                         .to = spec_of("--to", to_, degrees),
                                         .conversion = attitudes_.added_to(RowOptions::settings(), degrees),
                                         .continuous = attitudes_.continuous,
                                         .stop_at_error = on_error() == stream::OnError::stop};
        PropagationSettings& settings = rows.settings;
        settings.representation = spec_of("--with", with_, false);
        require_rates("--with", settings.representation);
        settings.integrator = integrator_of(settings.representation, integrator_);
        settings.interpolation = one_of<Interpolation>(
            "interpolation", interpolation_, {{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}});
        settings.renormalise = renormalise_;
        if (!substeps_.empty()) {
            settings.substeps = static_cast<std::size_t>(count_of("--substeps", substeps_, 1'000'000));
        }
        const double tolerance = rows.conversion.tolerance;
        if (!initial_.empty()) {
            settings.initial = attitude_of("--initial", initial_, degrees, tolerance).rotation;
        }
        auto numbers = operations::propagation_numbers();
        numbers.has_unit = !time_unit_.empty();
        messages::Subject about{"t wx wy wz", numbers.names.size(), settings.representation.name, tolerance, true};
        return rows_command({.list = columns}, std::move(numbers), operations::propagate(rows), std::move(about),
                            operands);
    }

private:
    std::string to_;
    std::string initial_;
    std::string with_ = "quat";
    std::string integrator_;
    std::string substeps_;
    std::string interpolation_ = "linear";
    std::string time_unit_;
    bool renormalise_ = false;
    AttitudeOptions attitudes_;
};

} // namespace

std::unique_ptr<CommandOptions> propagate_options() { return std::make_unique<PropagateOptions>(); }

} // namespace rotconv::cli
