#include "../../core/kinematics/survey.hpp"
#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

/// @param condition the greatest that serves
std::string table_of(const Survey& survey, double condition, bool json) {
    const auto line = [](const auto&... cells) {
        return fmt::format("{:<10}  {:>1}  {:>12}  {:>7}  {:>18}  {:>7}  {:>6}  {:>8}  {}\n", cells...);
    };
    std::string text = json ? ""
                            : line("SET", "n", "least margin", "at line", "greatest condition", "at line", "jumps",
                                   "first at", "serves");
    for (const RepresentationSurvey& each : survey.representations()) {
        text +=
            json ? json_line({{"set", each.spec.text()},
                              {"parameters", each.spec.size()},
                              {"margin", each.least_margin},
                              {"margin_line", each.margin_row},
                              {"condition", each.greatest_condition},
                              {"condition_line", each.condition_row},
                              {"jumps", each.jumps},
                              {"jump_line", JsonValue(each.jump_row).unless(each.jumps == 0)},
                              {"serves", each.serves(condition)}})
                 : line(each.spec.text(), each.spec.size(), fmt::format("{:.6g}", each.least_margin), each.margin_row,
                        fmt::format("{:.6g}", each.greatest_condition), each.condition_row, each.jumps,
                        each.jumps == 0 ? "-" : std::to_string(each.jump_row), each.serves(condition) ? "yes" : "no");
    }
    return json ? text
                : text + fmt::format("\n{}; the smallest set that serves, with a condition of at most {}:\n",
                                     counted(survey.rows(), "attitude"), condition);
}

Conclusion conclusion_of(const Survey& survey, double condition, bool json) {
    if (survey.rows() == 0) {
        print_error(messages::nothing_read);
    }
    const RepresentationSurvey* best = survey.rows() == 0 ? nullptr : survey.smallest(condition);
    const std::string smallest = best != nullptr ? best->spec.text() : "none";
    const std::string end = json ? json_line({{"rows", survey.rows()}, {"smallest", smallest}}) : smallest + "\n";
    return {(survey.rows() == 0 ? "" : table_of(survey, condition, json)) + end, best != nullptr};
}

struct SurveyOptions final : RowOptions {
    SurveyOptions() {
        format.about = "pretty (default), a table, or json";
        format.choices = {"pretty", "json"};
        add("What", {&from, &condition});
        add("Output", {&format});
        add_reading();
    }

    [[nodiscard]] Command command() const override {
        refuse_values("survey");
        const Spec read = spec_of(from);
        const ConversionSettings reading = settings();
        const double most = amount_of(condition, 1e3, true);
        const bool json = one_of("format of survey", format, formats) == stream::Format::json;
        RowsCommand command = rows_command(operations::convert(Conversion(read, Spec{}, reading), false));
        const auto fold = std::make_shared<operations::SurveyFold>();
        command.options.writes_rows = false;
        command.options.fold = fold;
        command.conclude = [=](const RowsCommand&, const RowsResult&) {
            return conclusion_of(fold->survey, most, json);
        };
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
