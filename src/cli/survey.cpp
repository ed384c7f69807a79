#include "survey.hpp"

#include <cmath>

#include <rotconv/survey.hpp>

#include "../stream/fmt.hpp"
#include "messages.hpp"
#include "print_error.hpp"
#include "rows.hpp"

namespace rotconv::cli {
namespace {

std::string in_table(const Survey& survey, double limit) {
    std::string text =
        fmt::format("{:<10}  {:>1}  {:>12}  {:>7}  {:>18}  {:>7}  {:>6}  {:>8}  {}\n", "SET", "n", "least margin",
                    "at line", "greatest condition", "at line", "jumps", "first at", "serves");
    for (const SetSurvey& set : survey.sets()) {
        text += fmt::format("{:<10}  {:>1}  {:>12.6g}  {:>7}  {:>18.6g}  {:>7}  {:>6}  {:>8}  {}\n",
                            messages::spec_text(set.set), set.set.size(), set.least_margin, set.margin_row,
                            set.greatest_condition, set.condition_row, set.jumps,
                            set.jumps == 0 ? "-" : std::to_string(set.jump_row), set.serves(limit) ? "yes" : "no");
    }
    return text;
}

std::string in_json(const Survey& survey, double limit) {
    std::string text;
    for (const SetSurvey& set : survey.sets()) {
        text += fmt::format(R"({{"set": "{}", "parameters": {}, "margin": {}, "margin_line": {}, "condition": {}, )"
                            R"("condition_line": {}, "jumps": {}, "jump_line": {}, "serves": {}}})"
                            "\n",
                            messages::spec_text(set.set), set.set.size(), messages::json_number(set.least_margin),
                            set.margin_row, messages::json_number(set.greatest_condition), set.condition_row, set.jumps,
                            set.jumps == 0 ? "null" : std::to_string(set.jump_row), set.serves(limit));
    }
    return text;
}

} // namespace

ExitCode survey(const SurveyCommand& command) {
    const Survey& survey = *command.survey;
    bool none_serves = false;
    stream::NullSink nowhere;
    const auto conclude = [&](const RowsResult& /*result*/) {
        if (survey.rows() == 0) {
            print_error(messages::nothing_read);
            none_serves = true;
            return std::string(command.json ? "{\"rows\": 0, \"smallest\": \"none\"}\n" : "none\n");
        }
        const SetSurvey* smallest = survey.smallest(command.condition);
        none_serves = smallest == nullptr;
        const std::string name = none_serves ? "none" : messages::spec_text(smallest->set);
        return command.json
                   ? fmt::format("{}{{\"rows\": {}, \"smallest\": \"{}\"}}\n", in_json(survey, command.condition),
                                 survey.rows(), name)
                   : fmt::format(
                         "{}\n{} attitude{}; the smallest set that serves, with a condition of at most {}:\n{}\n",
                         in_table(survey, command.condition), survey.rows(), survey.rows() == 1 ? "" : "s",
                         command.condition, name);
    };
    const RowsResult result = run_rows(command.rows, Conclusion{nowhere, conclude});
    return result.code == ExitCode::done && none_serves ? ExitCode::reservations : result.code;
}

} // namespace rotconv::cli
