#include "reporter.hpp"

#include <algorithm>
#include <limits>
#include <variant>

#include "../stream/fmt.hpp"
#include "advice.hpp"
#include "print_error.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t told_errors = 20;
constexpr std::size_t every_error = std::numeric_limits<std::size_t>::max();

std::string rows_from(std::size_t rows, std::size_t first_line) {
    return fmt::format("{}, first at line {}", counted(rows, "row"), first_line);
}

} // namespace

Reporter::Reporter(const RowsCommand& command, bool failed_rows_show_it)
    : command_(&command), most_errors_(failed_rows_show_it ? told_errors : every_error),
      where_(command.has_values ? "argument" : shown(command.input)), reference_(shown(command.reference)) {}

void Reporter::operator()(const stream::Event& event) {
    std::visit([this](const auto& what) { add(what); }, event);
}

void Reporter::operator()(const stream::StreamError& error) const {
    using What = stream::StreamError::What;
    std::string message = messages::explain(error, subject_of(error.of_reference));
    if (error.what == What::json) {
        message += json_advice(beginning_, command_->options.input);
    } else if (error.what == What::columns && error.column.header.empty() && !error.of_reference) {
        message += advice_at(error.line);
    }
    tell(error.what == What::read ? 0 : error.line, message, error.of_reference);
}

void Reporter::operator()(const stream::Unpaired& unpaired, bool of_reference) const {
    if (unpaired.rows > 0) {
        tell(0, fmt::format("unpaired: {}", rows_from(unpaired.rows, unpaired.first_line)), of_reference);
    }
}

void Reporter::summarize() const {
    if (command_->diagnostics != ShowDiagnostics::summary) {
        return;
    }
    for (const Count& count : counts_) {
        if (count.rows == 0 || is_told_apart(count.first)) {
            continue;
        }
        if (command_->has_values) {
            tell(0, messages::describe(count.first));
        } else {
            tell(0,
                 fmt::format("{}: {}; {}", name_of(count.first.kind), rows_from(count.rows, count.first.line),
                             messages::meaning(count.first.kind)),
                 count.first.of_reference);
        }
    }
}

void Reporter::count_rest() const {
    if (errors_ > most_errors_) {
        tell(0, counted(errors_ - most_errors_, "more row") + " without a result");
    }
}

bool Reporter::met_singularity() const noexcept {
    return std::ranges::any_of(
        counts_, [](const Count& count) { return count.rows > 0 && count.first.kind != DiagnosticKind::normalized; });
}

void Reporter::add(const stream::RowError& error) {
    if (++errors_ > most_errors_) {
        return;
    }
    std::string message = messages::explain(error, subject_of(error.of_reference));
    if (errors_ == 1 && !error.of_reference) {
        message += advice_at(error.line);
    }
    tell(error.line, message, error.of_reference);
}

void Reporter::add(const stream::Diagnostic& diagnostic) {
    Count& count = counts_.at(index_of(diagnostic.kind, diagnostic.of_reference));
    if (count.rows == 0) {
        count.first = diagnostic;
    }
    if (count.rows == 0 || count.last_line != diagnostic.line) { // a row may have several answers
        ++count.rows;
        count.last_line = diagnostic.line;
    }
    if (command_->diagnostics == ShowDiagnostics::rows || is_told_apart(diagnostic)) {
        tell(diagnostic.line, messages::describe(diagnostic), diagnostic.of_reference);
    }
}

void Reporter::tell(std::size_t line, const std::string& message, bool of_reference) const {
    const std::string& where = of_reference ? reference_ : where_;
    if (line == 0 || command_->has_values) {
        print_error(fmt::format("{}: {}", where, message));
    } else {
        print_error(fmt::format("{}:{}: {}", where, line, message));
    }
}

std::string Reporter::advice_at(std::size_t line) const {
    const bool is_text = !command_->has_values && command_->options.input.width == 0;
    const std::string text =
        is_text ? advice(beginning_, line, command_->options.input, command_->input) : std::string();
    return text.empty() ? text : "; " + text;
}

bool Reporter::is_told_apart(const stream::Diagnostic& diagnostic) const noexcept {
    return command_->has_values && command_->diagnostics == ShowDiagnostics::summary && !diagnostic.answer.empty();
}

} // namespace rotconv::cli
