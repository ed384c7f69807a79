#include <utility>

#include <rotconv/rates.hpp>

#include "row_options.hpp"

namespace rotconv::cli {
namespace {

Command rates(const Given& given) {
    const bool takes_differences = given.has("--differences");
    const bool is_inverse = given.has("--inverse");
    if (takes_differences && is_inverse) {
        throw Usage("--inverse cannot be combined with --differences");
    }
    if (takes_differences) {
        refuse_values(given, "rates --differences");
    }
    const Spec spec = spec_of(given, "--from");
    const Frame frame = frame_of(given);
    const bool degrees = given.has("--degrees");
    const ConversionSettings reading = settings_of(given);
    const auto command = [&](const std::string& subject, const stream::RowNumbers& numbers,
                             operations::Operation operation) {
        return rows_command(given, {.list = given.text("--columns")}, numbers, std::move(operation),
                            {subject, numbers.names.size(), spec.name, reading.tolerance});
    };
    const std::string_view name = representation(spec.name).text;
    if (takes_differences) {
        auto numbers = operations::difference_numbers(spec);
        numbers.has_unit = given.has("--time-unit");
        return command(fmt::format("t with {}", name), numbers,
                       operations::differences({.spec = spec,
                                                .time_power = time_power_of(given.text("--time-unit")),
                                                .degrees = degrees,
                                                .frame = frame,
                                                .tolerance = reading.tolerance,
                                                .sensitivity = reading.sensitivity,
                                                .decimal = reading.decimal}));
    }
    require_rates("--from", spec);
    const RateSettings settings{.inverse = is_inverse,
                                .degrees = degrees,
                                .frame = frame,
                                .tolerance = reading.tolerance,
                                .sensitivity = reading.sensitivity,
                                .decimal = reading.decimal};
    return command(fmt::format("{} with {}", name, is_inverse ? "its rates" : "wx wy wz"),
                   operations::rates_numbers(spec, settings), operations::rates(spec, settings));
}

} // namespace

CommandEntry rates_command() {
    OptionSet set;
    set.add("-f,--from", "SPEC", "The representation to read: NAME[:MODIFIER]...");
    set.add("--frame", "FRAME", "Axes of the angular velocity: body (default) or reference");
    set.add_flag("--inverse", "Read the numbers and their rates, print the angular velocity");
    set.add_flag("--differences", "Read times and attitudes, print the angular velocity between rows");
    set.add("--time-unit", "UNIT", "Unit of the times: s (default), ms, us or ns");
    add_reading(set);
    set.describe("--degrees", "Degrees, and degrees a second; :deg alone leaves radians a second");
    add_writing(set);
    return {"rates", "Turn angular velocity into rates of change of the numbers, and back",
            "Usage: rotconv rates -f SPEC [OPTION]... [VALUE]...\n"
            "       rotconv rates -f SPEC [OPTION]... [FILE]\n"
            "       rotconv rates --differences -f SPEC [OPTION]... [FILE]\n",
            std::move(set), rates};
}

} // namespace rotconv::cli
