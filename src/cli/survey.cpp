
#include <rotconv/survey.hpp>

#include "row_options.hpp"

namespace rotconv::cli {
namespace {

class SurveyConclusion final : public Conclusion {
public:
    SurveyConclusion(double condition, bool json) : condition_(condition), json_(json) {}

    [[nodiscard]] Survey& survey() noexcept { return survey_; }

    [[nodiscard]] Answer answer(const RowsResult& /*result*/) override {
        if (survey_.rows() == 0) {
            print_error(messages::nothing_read);
        }
        const RepresentationSurvey* best = survey_.rows() == 0 ? nullptr : survey_.smallest(condition_);
        const std::string smallest = best != nullptr ? best->spec.text() : "none";
        const std::string end = json_ ? json_line({{"rows", survey_.rows()}, {"smallest", smallest}}) : smallest + "\n";
        return {(survey_.rows() == 0 ? "" : table()) + end, best != nullptr};
    }

private:
    [[nodiscard]] std::string table() const {
        const auto line = [](const auto&... cells) {
            return fmt::format("{:<10}  {:>1}  {:>12}  {:>7}  {:>18}  {:>7}  {:>6}  {:>8}  {}\n", cells...);
        };
        std::string text = json_ ? ""
                                 : line("SET", "n", "least margin", "at line", "greatest condition", "at line", "jumps",
                                        "first at", "serves");
        for (const RepresentationSurvey& each : survey_.representations()) {
            text += json_ ? json_line({{"set", each.spec.text()},
                                       {"parameters", each.spec.size()},
                                       {"margin", each.least_margin},
                                       {"margin_line", each.margin_row},
                                       {"condition", each.greatest_condition},
                                       {"condition_line", each.condition_row},
                                       {"jumps", each.jumps},
                                       {"jump_line", each.jumps == 0 ? JsonValue() : JsonValue(each.jump_row)},
                                       {"serves", each.serves(condition_)}})
                          : line(each.spec.text(), each.spec.size(), fmt::format("{:.6g}", each.least_margin),
                                 each.margin_row, fmt::format("{:.6g}", each.greatest_condition), each.condition_row,
                                 each.jumps, each.jumps == 0 ? "-" : std::to_string(each.jump_row),
                                 each.serves(condition_) ? "yes" : "no");
        }
        return json_ ? text
                     : text + fmt::format("\n{}; the smallest set that serves, with a condition of at most {}:\n",
                                          counted(survey_.rows(), "attitude"), condition_);
    }

    Survey survey_;
    double condition_; ///< the greatest that serves
    bool json_;
};

struct SurveyOptions final : RowOptions {
    SurveyOptions() {
        format.about = "pretty (default), a table, or json";
        add("What", {&from, &condition});
        add("Output", {&format});
        add_reading();
    }

    [[nodiscard]] Command command() const override {
        refuse_values("survey");
        const Spec read = spec_of(from);
        const ConversionSettings reading = settings();
        const auto conclusion = std::make_shared<SurveyConclusion>(
            amount_of(condition, 1e3, true),
            one_of<bool>("format of survey", format, {{"pretty", false}, {"json", true}}));
        RowsCommand command =
            rows_command(operations::attitude_numbers(read), operations::survey(read, reading, conclusion->survey()),
                         messages::subject_of(read, reading.tolerance));
        command.options.format = stream::Format::result;
        command.conclusion = conclusion;
        return command;
    }

    Option condition{"--condition", "LIMIT", "The greatest condition that serves (default 1e3)"};
};

} // namespace

CommandEntry survey_command() {
    return {"survey", "Find the representations that serve a motion, and the smallest",
            "Usage: rotconv survey -f SPEC [OPTION]... [FILE]\n", make_options<SurveyOptions>};
}

} // namespace rotconv::cli
