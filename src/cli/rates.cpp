#include <utility>

#include <rotconv/rates.hpp>

#include "../stream/fmt.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

class RatesOptions final : public RowOptions {
public:
    RatesOptions() {
        set.begin_group("What");
        set.add("-f,--from", from_, "SPEC", "The representation to read: NAME[:MODIFIER]...");
        set.add("--frame", frame_, "FRAME", "Axes of the angular velocity: body (default) or reference");
        set.add("--inverse", inverse_, "Read the numbers and their rates, print the angular velocity");
        set.add("--differences", differences_, "Read times and attitudes, print the angular velocity between rows");
        set.add("--time-unit", time_unit_, "UNIT", "Unit of the times: s (default), ms, us or ns");
        add_reading();
        set.describe("--degrees", "Degrees, and degrees a second; :deg alone leaves radians a second");
        add_writing();
    }

    [[nodiscard]] Command command(const Operands& operands) const override {
        if (differences_ && inverse_) {
            throw Usage("--inverse cannot be combined with --differences");
        }
        if (differences_) {
            refuse_values(operands, "rates --differences");
        }
        const Spec spec = spec_of("--from", from_, degrees);
        const Frame frame = frame_of(frame_);
        const ConversionSettings reading = settings();
        const auto command = [&](std::string_view subject, stream::RowNumbers numbers,
                                 operations::Operation operation) {
            messages::Subject about{fmt::format(fmt::runtime(subject), representation(spec.name).text),
                                    numbers.names.size(), spec.name, reading.tolerance};
            return rows_command({.list = columns}, std::move(numbers), std::move(operation), std::move(about),
                                operands);
        };
        if (differences_) {
            auto numbers = operations::difference_numbers(spec);
            numbers.has_unit = !time_unit_.empty();
            return command("t with {}", std::move(numbers),
                           operations::differences({.spec = spec,
                                                    .time_power = time_power_of(time_unit_),
                                                    .degrees = degrees,
                                                    .frame = frame,
                                                    .tolerance = reading.tolerance,
                                                    .sensitivity = reading.sensitivity}));
        }
        require_rates("--from", spec);
        const RateSettings rates{.inverse = inverse_,
                                 .degrees = degrees,
                                 .frame = frame,
                                 .tolerance = reading.tolerance,
                                 .sensitivity = reading.sensitivity};
        return command(inverse_ ? "{} with its rates" : "{} with wx wy wz", operations::rates_numbers(spec, rates),
                       operations::rates(spec, rates));
    }

private:
    std::string from_;
    std::string frame_ = "body";
    std::string time_unit_;
    bool inverse_ = false;
    bool differences_ = false;
};

} // namespace

std::unique_ptr<CommandOptions> rates_options() { return std::make_unique<RatesOptions>(); }

} // namespace rotconv::cli
