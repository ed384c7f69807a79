#include <utility>

#include <rotconv/rates.hpp>

#include "../stream/fmt.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

class RatesOptions final : public CommandOptions {
public:
    RatesOptions() {
        set.begin_group("What");
        set.add("-f,--from", from_, "SPEC", "The representation to read: NAME[:MODIFIER]...");
        set.add("--frame", frame_, "FRAME", "Axes of the angular velocity: body (default) or reference");
        set.add("--inverse", inverse_, "Read the numbers and their rates, print the angular velocity");
        set.add("--differences", differences_, "Read times and attitudes, print the angular velocity between rows");
        set.add("--time-unit", time_unit_, "UNIT", "Unit of the times: s (default), ms, us or ns");
        reading_.add_to(set);
        set.describe("--degrees", "Degrees, and degrees a second; :deg alone leaves radians a second");
        writing_.add_to(set);
    }

    [[nodiscard]] std::string input() const override { return reading_.input; }

    [[nodiscard]] Command command(const Operands& operands) const override {
        if (differences_ && inverse_) {
            throw Usage("--inverse and --differences exclude each other");
        }
        if (differences_) {
            refuse_values(operands, "rates --differences");
        }
        const Spec spec = spec_of("--from", from_, reading_.degrees);
        const double tolerance = reading_.greatest_defect();
        const bool sensitivity = writing_.shown_diagnostics() == ShowDiagnostics::columns;
        const std::string name(representation(spec.name).text);
        if (differences_) {
            return command(fmt::format("t with {}", name), spec, operations::difference_numbers(spec),
                           operations::differences({.spec = spec,
                                                    .time_power = time_power_of(time_unit_),
                                                    .degrees = reading_.degrees,
                                                    .frame = frame_of(frame_),
                                                    .tolerance = tolerance,
                                                    .sensitivity = sensitivity}),
                           operands);
        }
        require_rates("--from", spec);
        const RateSettings settings{.inverse = inverse_,
                                    .degrees = reading_.degrees,
                                    .frame = frame_of(frame_),
                                    .tolerance = tolerance,
                                    .sensitivity = sensitivity};
        return command(fmt::format("{} with {}", name, inverse_ ? "its rates" : "wx wy wz"), spec,
                       operations::rates_numbers(spec, settings), operations::rates(spec, settings), operands);
    }

private:
    [[nodiscard]] RowsCommand command(std::string subject, const Spec& spec, stream::RowNumbers numbers,
                                      operations::Operation operation, const Operands& operands) const {
        messages::Subject about{std::move(subject), numbers.names.size(), spec.name, reading_.greatest_defect()};
        return rows_command(reading_, writing_, {.list = reading_.columns}, std::move(numbers), std::move(operation),
                            std::move(about), operands);
    }

    std::string from_;
    std::string frame_ = "body";
    std::string time_unit_ = "s";
    bool inverse_ = false;
    bool differences_ = false;
    ReadingOptions reading_;
    WritingOptions writing_;
};

} // namespace

std::unique_ptr<CommandOptions> rates_options() { return std::make_unique<RatesOptions>(); }

} // namespace rotconv::cli
