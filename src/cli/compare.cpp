#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include <rotconv/comparison.hpp>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "print_error.hpp"
#include "row_options.hpp"

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

class ComparisonConclusion final : public Conclusion {
public:
    enum class Format : std::uint8_t { pretty, json, csv };

    ComparisonConclusion(Format format, std::optional<double> within, stream::Digits digits, bool by_key)
        : format_(format), within_(within), digits_(digits), by_key_(by_key) {}

    [[nodiscard]] stream::Sink* rows() override { return format_ == Format::csv ? nullptr : &angles_; }

    [[nodiscard]] std::string text(const RowsResult& result) override {
        if (result.answered == 0 && result.code == ExitCode::done) {
            const bool no_key = by_key_ && unpaired(result) > 0;
            print_error(no_key ? "no key of FILE is one of REFERENCE (--key-within says how much they may differ)"
                               : messages::nothing_read);
        }
        return format_ == Format::csv ? "" : format_ == Format::json ? in_json(result) : in_lines(result);
    }

    [[nodiscard]] bool holds(const RowsResult& result) const override {
        return result.answered > 0 && result.beyond == 0 && unpaired(result) == 0;
    }

private:
    static std::size_t unpaired(const RowsResult& result) { return result.unpaired[0].rows + result.unpaired[1].rows; }

    [[nodiscard]] std::string number(double value) const {
        stream::Buffer text;
        stream::append_number(text, value, digits_);
        return fmt::to_string(text);
    }

    [[nodiscard]] std::string in_lines(const RowsResult& result) const {
        std::string text = fmt::format("rows      {}\n", result.answered);
        if (within_) {
            text += fmt::format("beyond    {}\n", result.beyond);
        }
        text += fmt::format("unpaired  {}\nfailed    {}\n", unpaired(result), result.failed);
        if (!angles_.empty()) {
            text += fmt::format("max       {} at {}\nrms       {}\nmean      {}\n", number(angles_.largest()),
                                angles_.line_of_largest(), number(angles_.root_mean_square()), number(angles_.mean()));
        }
        return text;
    }

    [[nodiscard]] std::string in_json(const RowsResult& result) const {
        const auto angle = [this](double value) { return angles_.empty() ? "null" : number(value); };
        const auto count = [](bool is_there, std::size_t value) { return is_there ? std::to_string(value) : "null"; };
        return fmt::format(R"({{"rows": {}, "within": {}, "beyond": {}, "first_beyond": {}, "unpaired": {}, )"
                           R"("failed": {}, "max": {}, "max_line": {}, "rms": {}, "mean": {}}})"
                           "\n",
                           result.answered, within_ ? json_number(*within_) : "null",
                           count(within_.has_value(), result.beyond), count(result.beyond > 0, result.first_beyond),
                           unpaired(result), result.failed, angle(angles_.largest()),
                           count(!angles_.empty(), angles_.line_of_largest()), angle(angles_.root_mean_square()),
                           angle(angles_.mean()));
    }

    Format format_;
    std::optional<double> within_;
    stream::Digits digits_;
    bool by_key_;
    AngleSums angles_;
};

class CompareOptions final : public CommandOptions {
public:
    CompareOptions() {
        set.begin_group("What");
        set.add("-f,--from", from_, "SPEC", "The representation to read: NAME[:MODIFIER]...");
        set.add("-t,--to", to_, "SPEC", "The representation of the reference (default: that of --from)");
        set.add("--within", within_, "ANGLE", "The largest angle that passes, in radians or, with -d, degrees");
        set.add("--as", relative_, "SPEC", "With --format csv: print the relative attitude too, in SPEC");
        set.add("--frame", frame_, "FRAME", "Axes of the relative attitude: body (default) or reference");
        pairing_.add_to(set);
        reading_.add_to(set);
        writing_.add_to(set);
        set.describe("--format", "pretty (default), json, or csv: every pair with its angle");
        attitudes_.add_lock_margin_to(set);
    }

    [[nodiscard]] std::string input() const override { return reading_.input; }

    [[nodiscard]] Command command(const Operands& operands) const override {
        using Format = ComparisonConclusion::Format;
        const bool degrees = reading_.degrees;
        const Spec from = spec_of("--from", from_, degrees);
        const Spec reference = to_.empty() ? from : spec_of("--to", to_, degrees);
        const auto format = choose<Format>("format of compare", writing_.format.empty() ? "pretty" : writing_.format,
                                           {{"pretty", Format::pretty}, {"json", Format::json}, {"csv", Format::csv}});
        ComparisonSettings settings{.reading = attitudes_.settings(reading_, writing_),
                                    .within =
                                        amount_of("--within", within_, std::numeric_limits<double>::infinity(), true),
                                    .unit = degrees ? AngleUnit::degrees : AngleUnit::radians,
                                    .frame = frame_of(frame_)};
        if (!relative_.empty()) {
            const Spec relative = spec_of("--as", relative_, degrees);
            settings.relative = format == Format::csv ? std::optional(relative) : std::nullopt;
        }
        const Comparison comparison(from, reference, settings);

        const operations::ComparisonRows rows{.paired = PairingOptions::is_paired(operands),
                                              .by_key = pairing_.by_key(operands),
                                              .with_line = format != Format::csv};
        const double tolerance = settings.reading.tolerance;
        messages::Subject subject = messages::subject_of(from, tolerance);
        if (!rows.paired) {
            subject.text += to_.empty() ? " twice" : fmt::format(" with {}", representation(reference.name).text);
            subject.count = comparison.inputs();
        }
        WritingOptions writing = writing_;
        writing.format = "csv";
        RowsCommand command = rows_command(reading_, writing, file_columns(reading_, pairing_, operands),
                                           operations::comparison_numbers(comparison, rows),
                                           operations::compare(comparison, rows), std::move(subject), operands);
        command.options.append = format == Format::csv;
        command.options.format = format == Format::csv ? stream::Format::csv : stream::Format::result;
        command.conclusion = std::make_shared<ComparisonConclusion>(
            format, within_.empty() ? std::nullopt : std::optional(settings.within), command.options.digits,
            rows.by_key);
        if (rows.paired) {
            pair(command, reading_, pairing_, operations::attitude_numbers(reference, rows.by_key),
                 messages::subject_of(reference, tolerance), operands);
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
    ReadingOptions reading_;
    WritingOptions writing_;
};

} // namespace

std::unique_ptr<CommandOptions> compare_options() { return std::make_unique<CompareOptions>(); }

} // namespace rotconv::cli
