#include <utility>

#include "../methods/method_conversion.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

class ConvertOptions final : public RowOptions {
public:
    ConvertOptions() {
        set.begin_group("What");
        set.add("-f,--from", from_, "SPEC", "The representation to read: NAME[:MODIFIER]...");
        set.add("-t,--to", to_, "SPEC", "The representation to write: NAME[:MODIFIER]...");
        attitudes_.add_to(set);
        add_reading();
        add_writing();
        attitudes_.add_lock_margin_to(set);
        set.begin_group("More");
        set.add("--method", method_, "METHOD", "A published formula (see rotconv list methods), fast, or all of them");
    }

    [[nodiscard]] Command command(const Operands& operands) const override {
        if (from_.empty() && to_.empty()) {
            throw MissingSpec("--from SPEC and --to SPEC are missing; see rotconv --help");
        }
        const Spec from = spec_of("--from", from_, degrees);
        const Spec to = spec_of("--to", to_, degrees);
        ConversionSettings conversion = attitudes_.added_to(settings(), degrees);
        conversion.fast = method_ == fast_method;
        conversion.few_digits = !operands.values.empty() || input_format != "f64";
        operations::Operation operation = by_method(Conversion(from, to, conversion));
        if (operation->is_continuous && !operation->answers.empty()) {
            throw Usage("--continuous cannot be combined with --method all, which writes several answers to a row");
        }
        RowsCommand command = rows_command({.list = columns}, operations::attitude_numbers(from), std::move(operation),
                                           messages::subject_of(from, conversion.tolerance), operands);
        if (method_ == all_methods && command.options.format == stream::Format::f64) {
            throw Usage("--format f64 cannot be combined with --method all, which writes names");
        }
        return command;
    }

private:
    /// A method of rotconv's own, a published one, or all.
    [[nodiscard]] operations::Operation by_method(const Conversion& conversion) const {
        if (method_ == all_methods) {
            return operations::method(MethodConversion::all(conversion), true, attitudes_.continuous);
        }
        if (method_ == default_method || method_ == fast_method) {
            return operations::convert(conversion, attitudes_.continuous);
        }
        const Method* method = find_method(conversion.from().name, conversion.to().name, method_);
        if (method == nullptr) {
            throw Usage("--method " + messages::no_such_method(conversion.from().name, conversion.to().name, method_));
        }
        return operations::method(MethodConversion(conversion, *method), false, attitudes_.continuous);
    }

    std::string from_;
    std::string to_;
    std::string method_ = std::string(default_method);
    AttitudeOptions attitudes_;
};

} // namespace

std::unique_ptr<CommandOptions> convert_options() { return std::make_unique<ConvertOptions>(); }

} // namespace rotconv::cli
