#include <utility>

#include <rotconv/survey.hpp>

#include "../stream/fmt.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "print_error.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

constexpr double default_condition = 1e3;

class SurveyConclusion final : public Conclusion {
public:
    SurveyConclusion(double condition, bool json) : condition_(condition), json_(json) {}

    [[nodiscard]] Survey& survey() noexcept { return survey_; }
    [[nodiscard]] stream::Sink* rows() override { return &nowhere_; }

    [[nodiscard]] std::string text(const RowsResult& /*result*/) override {
        if (survey_.rows() == 0) {
            print_error(messages::nothing_read);
            return json_ ? "{\"rows\": 0, \"smallest\": \"none\"}\n" : "none\n";
        }
        const std::string smallest = has_smallest() ? survey_.smallest(condition_)->spec.text() : "none";
        if (json_) {
            return fmt::format("{}{{\"rows\": {}, \"smallest\": \"{}\"}}\n", in_json(), survey_.rows(), smallest);
        }
        return fmt::format("{}\n{}; the smallest set that serves, with a condition of at most {}:\n{}\n", in_table(),
                           counted(survey_.rows(), "attitude"), condition_, smallest);
    }

    [[nodiscard]] bool holds(const RowsResult& /*result*/) const override { return has_smallest(); }

private:
    [[nodiscard]] bool has_smallest() const { return survey_.rows() > 0 && survey_.smallest(condition_) != nullptr; }

    [[nodiscard]] std::string in_table() const {
        constexpr const char* line = "{:<10}  {:>1}  {:>12}  {:>7}  {:>18}  {:>7}  {:>6}  {:>8}  {}\n";
        std::string text = fmt::format(fmt::runtime(line), "SET", "n", "least margin", "at line", "greatest condition",
                                       "at line", "jumps", "first at", "serves");
        for (const RepresentationSurvey& survey : survey_.representations()) {
            text += fmt::format(
                fmt::runtime(line), survey.spec.text(), survey.spec.size(), fmt::format("{:.6g}", survey.least_margin),
                survey.margin_row, fmt::format("{:.6g}", survey.greatest_condition), survey.condition_row, survey.jumps,
                survey.jumps == 0 ? "-" : std::to_string(survey.jump_row), survey.serves(condition_) ? "yes" : "no");
        }
        return text;
    }

    [[nodiscard]] std::string in_json() const {
        std::string text;
        for (const RepresentationSurvey& survey : survey_.representations()) {
            text +=
                fmt::format(R"({{"set": "{}", "parameters": {}, "margin": {}, "margin_line": {}, "condition": {}, )"
                            R"("condition_line": {}, "jumps": {}, "jump_line": {}, "serves": {}}})"
                            "\n",
                            survey.spec.text(), survey.spec.size(), json_number(survey.least_margin), survey.margin_row,
                            json_number(survey.greatest_condition), survey.condition_row, survey.jumps,
                            survey.jumps == 0 ? "null" : std::to_string(survey.jump_row), survey.serves(condition_));
        }
        return text;
    }

    Survey survey_;
    double condition_; ///< the greatest that serves
    bool json_;
    stream::NullSink nowhere_;
};

class SurveyOptions final : public CommandOptions {
public:
    SurveyOptions() {
        set.begin_group("What");
        set.add("-f,--from", from_, "SPEC", "The representation to read: NAME[:MODIFIER]...");
        set.add("--condition", condition_, "LIMIT", "How much a representation may enlarge a small turn (default 1e3)");
        set.begin_group("Output");
        set.add("--format", format_, "FORMAT", "pretty (default), a table, or json");
        reading_.add_to(set);
    }

    [[nodiscard]] std::string input() const override { return reading_.input; }

    [[nodiscard]] Command command(const Operands& operands) const override {
        refuse_values(operands, "survey");
        const Spec from = spec_of("--from", from_, reading_.degrees);
        const double tolerance = reading_.greatest_defect();
        const auto conclusion = std::make_shared<SurveyConclusion>(
            amount_of("--condition", condition_, default_condition, true),
            choose<bool>("format of survey", format_, {{"pretty", false}, {"json", true}}));
        RowsCommand command = rows_command(reading_, {}, {.list = reading_.columns}, operations::attitude_numbers(from),
                                           operations::survey(from, tolerance, conclusion->survey()),
                                           messages::subject_of(from, tolerance), operands);
        command.options.format = stream::Format::result;
        command.conclusion = conclusion;
        return command;
    }

private:
    std::string from_;
    std::string condition_;
    std::string format_ = "pretty";
    ReadingOptions reading_;
};

} // namespace

std::unique_ptr<CommandOptions> survey_options() { return std::make_unique<SurveyOptions>(); }

} // namespace rotconv::cli
