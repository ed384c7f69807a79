#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include <rotconv/comparison.hpp>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// The largest of all angles, and their means. Takes rows of an angle and its line, as doubles, in their order.
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

enum class Format : std::uint8_t { pretty, json, csv };

class ComparisonConclusion final : public Conclusion {
public:
    ComparisonConclusion(Format format, std::optional<double> within, stream::Digits digits, bool by_key)
        : format_(format), within_(within), digits_(digits), by_key_(by_key) {}

    [[nodiscard]] stream::Sink* rows() override { return format_ == Format::csv ? nullptr : &angles_; }

    [[nodiscard]] Answer answer(const RowsResult& result) override {
        const std::size_t unpaired = result.unpaired[0].rows + result.unpaired[1].rows;
        if (result.answered == 0 && result.code == ExitCode::done) {
            print_error(by_key_ && unpaired > 0 ? messages::no_key_met(result.keys)
                                                : std::string(messages::nothing_read));
        }
        return {.text = format_ == Format::csv    ? ""
                        : format_ == Format::json ? in_json(result, unpaired)
                                                  : in_lines(result, unpaired),
                .holds = result.answered > 0 && result.beyond == 0 && unpaired == 0};
    }

private:
    [[nodiscard]] std::string number(double value) const {
        stream::Buffer text;
        stream::append_number(text, value, digits_);
        return fmt::to_string(text);
    }

    [[nodiscard]] std::string in_lines(const RowsResult& result, std::size_t unpaired) const {
        std::string text = fmt::format("rows      {}\n", result.answered);
        if (within_) {
            text += fmt::format("beyond    {}\n", result.beyond);
        }
        text += fmt::format("unpaired  {}\nfailed    {}\n", unpaired, result.failed);
        if (!angles_.empty()) {
            text += fmt::format("max       {} at {}\nrms       {}\nmean      {}\n", number(angles_.largest()),
                                angles_.line_of_largest(), number(angles_.root_mean_square()), number(angles_.mean()));
        }
        return text;
    }

    [[nodiscard]] std::string in_json(const RowsResult& result, std::size_t unpaired) const {
        const auto value_if = [](bool is_there, JsonValue value) { return is_there ? value : JsonValue(); };
        const auto angle = [this](double value) {
            return angles_.empty() ? JsonValue() : JsonValue::as_written(number(value));
        };
        return json_line({{"rows", result.answered},
                          {"within", value_if(within_.has_value(), within_.value_or(0.0))},
                          {"beyond", value_if(within_.has_value(), result.beyond)},
                          {"first_beyond", value_if(result.beyond > 0, result.first_beyond)},
                          {"unpaired", unpaired},
                          {"failed", result.failed},
                          {"max", angle(angles_.largest())},
                          {"max_line", value_if(!angles_.empty(), angles_.line_of_largest())},
                          {"rms", angle(angles_.root_mean_square())},
                          {"mean", angle(angles_.mean())}});
    }

    Format format_;
    std::optional<double> within_;
    stream::Digits digits_;
    bool by_key_;
    AngleSums angles_;
};

class CompareOptions final : public RowOptions {
public:
    CompareOptions() {
        set.begin_group("What");
        set.add("-f,--from", from_, "SPEC", "The representation to read: NAME[:MODIFIER]...");
        set.add("-t,--to", to_, "SPEC", "The representation of the reference (default: that of --from)");
        set.add("--within", within_, "ANGLE", "The largest angle that passes, in radians or, with -d, degrees");
        set.add("--as", relative_, "SPEC", "With --format csv: print the relative attitude too, in SPEC");
        set.add("--frame", frame_, "FRAME", "Axes of the relative attitude: body (default) or reference");
        attitudes_.add_to(set, false);
        pairing_.add_to(set, true);
        add_reading();
        add_writing();
        set.describe("--reference-axes", "Other reference axes of FILE's attitudes, such as ned:enu");
        set.describe("--body-axes", "Other body axes of FILE's attitudes, such as frd:flu, by their names");
        set.describe("--left", "Turn the attitudes R of FILE: compare L R; L as \"SPEC: NUMBERS\"");
        set.describe("--right", "Turn the attitudes R of FILE: compare R S; S as \"SPEC: NUMBERS\"");
        set.describe("--format", "pretty (default), json, or csv: every pair with its angle");
        attitudes_.add_lock_margin_to(set);
    }

    [[nodiscard]] Command command(const Operands& operands) const override {
        const Spec from = spec_of("--from", from_, degrees);
        const Spec reference = to_.empty() ? from : spec_of("--to", to_, degrees);
        const auto shown = one_of<Format>("format of compare", format.empty() ? "pretty" : format,
                                          {{"pretty", Format::pretty}, {"json", Format::json}, {"csv", Format::csv}});
        ComparisonSettings comparing{.reading = attitudes_.added_to(settings(), degrees),
                                     .within =
                                         amount_of("--within", within_, std::numeric_limits<double>::infinity(), true),
                                     .unit = degrees ? AngleUnit::degrees : AngleUnit::radians,
                                     .frame = frame_of(frame_)};
        if (!relative_.empty()) {
            const Spec relative = spec_of("--as", relative_, degrees);
            comparing.relative = shown == Format::csv ? std::optional(relative) : std::nullopt;
        }
        const Comparison comparison(from, reference, comparing);

        const operations::ComparisonRows rows{.paired = PairingOptions::is_paired(operands),
                                              .by_key = pairing_.by_key(operands),
                                              .with_line = shown != Format::csv,
                                              .interpolates =
                                                  pairing_.interpolates && PairingOptions::is_paired(operands)};
        messages::Subject subject = messages::subject_of(from, comparing.reading.tolerance);
        if (!rows.paired) {
            subject.text += to_.empty() ? " twice" : fmt::format(" with {}", representation(reference.name).text);
            subject.count = comparison.inputs();
        }
        RowsCommand command =
            rows_command(columns_of_file(pairing_, operands), operations::comparison_numbers(comparison, rows),
                         operations::compare(comparison, rows), std::move(subject), operands);
        command.options.append = shown == Format::csv;
        command.options.format = shown == Format::csv ? stream::Format::csv : stream::Format::result;
        command.conclusion = std::make_shared<ComparisonConclusion>(
            shown, within_.empty() ? std::nullopt : std::optional(comparing.within), command.options.digits,
            rows.by_key);
        if (rows.paired) {
            pair(command, pairing_, operations::attitude_numbers(reference, rows.by_key),
                 messages::subject_of(reference, comparing.reading.tolerance), operands);
        }
        return command;
    }

private:
    std::string from_;
    std::string to_;
    std::string within_;
    std::string relative_;
    std::string frame_ = "body";
    PairingOptions pairing_;
    AttitudeOptions attitudes_;
};

} // namespace

std::unique_ptr<CommandOptions> compare_options() { return std::make_unique<CompareOptions>(); }

} // namespace rotconv::cli
