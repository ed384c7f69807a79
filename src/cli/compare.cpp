#include "compare.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <CLI/CLI.hpp>

#include <rotconv/comparison.hpp>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "pairing.hpp"
#include "print_error.hpp"
#include "rows.hpp"

namespace rotconv::cli {
namespace {

/// What all angles come to. Takes rows of an angle and its line, as doubles, in their order.
class AngleSums final : public stream::Sink {
public:
    int write(std::string_view bytes) override {
        struct {
            double angle = 0.0;
            double line = 0.0;
        } row;
        for (; !bytes.empty(); bytes.remove_prefix(sizeof row)) {
            std::memcpy(&row, bytes.data(), sizeof row);
            if (!std::isnan(row.angle)) { // a row without a result
                add(row.angle, static_cast<std::size_t>(row.line));
            }
        }
        return 0;
    }

    [[nodiscard]] bool empty() const noexcept { return rows_ == 0.0; }
    [[nodiscard]] double largest() const noexcept { return largest_; }
    [[nodiscard]] std::size_t line_of_largest() const noexcept { return line_; }
    [[nodiscard]] double mean() const noexcept { return (sum_ + lost_) / rows_; }
    [[nodiscard]] double root_mean_square() const noexcept { return scale_ * std::sqrt(squares_ / rows_); }

private:
    void add(double angle, std::size_t line) noexcept {
        if (rows_ == 0.0 || angle > largest_) {
            largest_ = angle;
            line_ = line;
        }
        rows_ += 1.0;
        const double sum = sum_ + angle; // Kahan and Neumaier: what each addition loses is kept
        lost_ += sum_ >= angle ? (sum_ - sum) + angle : (angle - sum) + sum_;
        sum_ = sum;
        if (angle > scale_) { // squares of the smallest angles would underflow
            squares_ *= (scale_ / angle) * (scale_ / angle);
            scale_ = angle;
        }
        if (angle > 0.0) {
            squares_ += (angle / scale_) * (angle / scale_);
        }
    }

    double rows_ = 0.0;
    double largest_ = 0.0;
    std::size_t line_ = 0;
    double sum_ = 0.0;
    double lost_ = 0.0;
    double scale_ = 0.0;
    double squares_ = 0.0; ///< of the angles over the scale
};

std::string number(double value, stream::Digits digits) {
    stream::Buffer text;
    stream::append_number(text, value, digits);
    return fmt::to_string(text);
}

std::string in_lines(const CompareCommand& command, const RowsResult& result, const AngleSums& angles) {
    const stream::Digits digits = command.rows.options.digits;
    std::string text = fmt::format("rows      {}\n", result.answered);
    if (command.within) {
        text += fmt::format("beyond    {}\n", result.beyond);
    }
    text +=
        fmt::format("unpaired  {}\nfailed    {}\n", result.unpaired[0].rows + result.unpaired[1].rows, result.failed);
    if (!angles.empty()) {
        text += fmt::format("max       {} at {}\nrms       {}\nmean      {}\n", number(angles.largest(), digits),
                            angles.line_of_largest(), number(angles.root_mean_square(), digits),
                            number(angles.mean(), digits));
    }
    return text;
}

std::string in_json(const CompareCommand& command, const RowsResult& result, const AngleSums& angles) {
    const auto angle = [&](double value) {
        return angles.empty() ? "null" : number(value, command.rows.options.digits);
    };
    const auto count = [](bool is_there, std::size_t value) { return is_there ? std::to_string(value) : "null"; };
    return fmt::format(R"({{"rows": {}, "within": {}, "beyond": {}, "first_beyond": {}, "unpaired": {}, )"
                       R"("failed": {}, "max": {}, "max_line": {}, "rms": {}, "mean": {}}})"
                       "\n",
                       result.answered, command.within ? messages::json_number(*command.within) : "null",
                       count(command.within.has_value(), result.beyond), count(result.beyond > 0, result.first_beyond),
                       result.unpaired[0].rows + result.unpaired[1].rows, result.failed, angle(angles.largest()),
                       count(!angles.empty(), angles.line_of_largest()), angle(angles.root_mean_square()),
                       angle(angles.mean()));
}

} // namespace

void define_compare(CLI::App& app, RawOptions& texts) {
    define_from(app, texts);
    app.add_option("-t,--to", texts.to, "The representation of the reference (default: that of --from)")
        ->type_name("SPEC");
    app.add_option("--within", texts.within, "The largest angle that passes, in radians or, with -d, degrees")
        ->type_name("ANGLE");
    app.add_option("--as", texts.relative, "With --format csv: print the relative attitude too, in SPEC")
        ->type_name("SPEC");
    app.add_option("--frame", texts.frame, "Axes of the relative attitude: body (default) or reference")
        ->type_name("FRAME");
    define_pairing(app, texts);
    define_input(app, texts);
    define_output(app, texts);
    app.get_option("--format")->description("pretty (default), json, or csv: every pair with its angle");
    define_lock_margin(app, texts);
}

CompareCommand compare_command(const RawOptions& texts, const Operands& operands) {
    using Format = CompareCommand::Format;
    const Spec from = spec_of("--from", texts.from, texts.degrees);
    const Spec reference = texts.to.empty() ? from : spec_of("--to", texts.to, texts.degrees);
    const auto format = choose<Format>("format of compare", texts.format.empty() ? "pretty" : texts.format,
                                       {{"pretty", Format::pretty}, {"json", Format::json}, {"csv", Format::csv}});
    ComparisonSettings settings{
        .reading = settings_of(texts),
        .within = amount_of("--within", texts.within, std::numeric_limits<double>::infinity(), true),
        .unit = texts.degrees ? AngleUnit::degrees : AngleUnit::radians,
        .frame = choose<Frame>("frame", texts.frame, {{"body", Frame::body}, {"reference", Frame::reference}})};
    if (!texts.relative.empty()) {
        const Spec relative = spec_of("--as", texts.relative, texts.degrees);
        settings.relative = format == Format::csv ? std::optional(relative) : std::nullopt;
    }
    const Comparison comparison(from, reference, settings);

    const bool paired = is_paired(operands);
    const stream::ComparisonRows rows{
        .paired = paired, .by_key = paired && !texts.key.empty(), .with_line = format != Format::csv};
    const double tolerance = settings.reading.tolerance;
    messages::Subject subject = messages::subject_of(from, tolerance);
    if (!paired) {
        subject.text += texts.to.empty() ? " twice" : fmt::format(" with {}", representation(reference.name).text);
        subject.count = comparison.inputs();
    }
    RawOptions input = file_options(texts, paired);
    input.format = "csv";
    CompareCommand command{
        .rows = rows_command(input, stream::comparison_operation(comparison, rows), std::move(subject), operands),
        .within = texts.within.empty() ? std::nullopt : std::optional(settings.within),
        .format = format};
    stream::Options& options = command.rows.options;
    options.append = format == Format::csv;
    if (format != Format::csv) {
        options.format = stream::Format::result;
    }
    if (paired) {
        pair(command.rows, texts, operands, stream::reference_operation(reference, rows.by_key),
             messages::subject_of(reference, tolerance));
    }
    return command;
}

ExitCode compare(const CompareCommand& command) {
    AngleSums angles;
    const auto conclude = [&](const RowsResult& result) {
        return command.format == CompareCommand::Format::json ? in_json(command, result, angles)
                                                              : in_lines(command, result, angles);
    };
    const RowsResult result = command.format == CompareCommand::Format::csv
                                  ? run_rows(command.rows)
                                  : run_rows(command.rows, Conclusion{angles, conclude});
    if (result.code != ExitCode::done || result.reader_left) {
        return result.code;
    }
    if (result.answered == 0) {
        print_error(messages::nothing_read);
    }
    const bool holds =
        result.answered > 0 && result.beyond == 0 && result.unpaired[0].rows == 0 && result.unpaired[1].rows == 0;
    return holds ? ExitCode::done : ExitCode::reservations;
}

} // namespace rotconv::cli
