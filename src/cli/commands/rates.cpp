#include <rotconv/rates.hpp>

#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

struct RatesOptions final : RowOptions {
    RatesOptions() {
        degrees.about = "Degrees, and degrees a second; :deg alone leaves radians a second";
        add("What", {&from, &frame, &inverse, &differences, &time_unit});
        add_reading();
        add_writing();
    }

    [[nodiscard]] Command command() const override {
        if (differences.given() && inverse.given()) {
            throw Usage("{} cannot be combined with {}", inverse.name(), differences.name());
        }
        if (differences.given()) {
            refuse_values(fmt::format("rates {}", differences.name()));
        }
        const Spec spec = spec_of(from);
        const auto axes =
            one_of("frame", frame, Choices<Frame>{{"body", Frame::body}, {"reference", Frame::reference}});
        const ConversionSettings reading = settings();
        const RateSettings rates{.inverse = inverse.given(),
                                 .degrees = degrees.given(),
                                 .frame = axes,
                                 .tolerance = reading.tolerance,
                                 .sensitivity = reading.sensitivity};
        const auto name = representation(spec.name).text;
        if (differences.given()) {
            return rows_command(operations::differences(spec, rates, time_power_of(time_unit)),
                                fmt::format("t with {}", name));
        }
        require_rates(from, spec);
        return rows_command(operations::rates(spec, rates),
                            fmt::format("{} with {}", name, inverse.given() ? "its rates" : "wx wy wz"));
    }

    Option frame{
        "--frame", "FRAME", "Axes of the angular velocity: body (default) or reference", {"body", "reference"}};
    Option inverse{"--inverse", "", "Read the numbers and their rates, print the angular velocity"};
    Option differences{"--differences", "", "Read times and attitudes, print the angular velocity between rows"};
};

} // namespace

CommandEntry rates_command() {
    return {"rates", "Turn angular velocity into rates of change of the numbers, and back",
            "Usage: rotconv rates -f SPEC [OPTION]... [VALUE]...\n"
            "       rotconv rates -f SPEC [OPTION]... [FILE]\n"
            "       rotconv rates --differences -f SPEC [OPTION]... [FILE]\n",
            make_options<RatesOptions>};
}

} // namespace rotconv::cli
