#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "../stream/event.hpp"
#include "command.hpp"

namespace rotconv::cli {

/// Words what happens in a run as it comes, counts it, and words the summary.
class Reporter {
public:
    /// @param failed_rows_show_it in the output, so that not all of them need be told of
    Reporter(const RowsCommand& command, bool failed_rows_show_it);

    void operator()(const stream::Event& event);
    void operator()(const stream::StreamError& error) const;
    void operator()(const stream::Unpaired& unpaired, bool of_reference) const;
    void summarize() const;
    /// What the limit has left out.
    void count_rest() const;

    [[nodiscard]] std::size_t errors() const noexcept { return errors_; }
    [[nodiscard]] std::size_t rows(DiagnosticKind kind) const { return count_of(kind).rows; }
    [[nodiscard]] std::size_t first_line(DiagnosticKind kind) const { return count_of(kind).first.line; }
    /// Any kind but normalized.
    [[nodiscard]] bool met_singularity() const noexcept;

private:
    struct Count {
        std::size_t rows = 0;
        std::size_t last_line = 0;
        stream::Diagnostic first{};
    };

    void add(const stream::RowError& error);
    void add(const stream::Diagnostic& diagnostic);
    void add(const stream::FirstBytes& first) { beginning_ = first.text; }

    void tell(std::size_t line, const std::string& message, bool of_reference = false) const;
    /// What to do about a line before the first row that could be read: the end of its message.
    [[nodiscard]] std::string advice_at(std::size_t line) const;
    /// Of the one row, one of several answers: each is told, as a summary would name one only.
    [[nodiscard]] bool is_told_apart(const stream::Diagnostic& diagnostic) const noexcept;
    [[nodiscard]] const Count& count_of(DiagnosticKind kind) const { return counts_.at(index_of(kind, false)); }
    static constexpr std::size_t index_of(DiagnosticKind kind, bool of_reference) noexcept {
        return static_cast<std::size_t>(kind) + (of_reference ? diagnostic_kind_count : 0);
    }
    [[nodiscard]] const messages::Subject& subject_of(bool of_reference) const noexcept {
        return of_reference ? command_->reference_subject : *command_->subject;
    }

    const RowsCommand* command_;
    std::size_t most_errors_;
    std::string where_;
    std::string reference_;
    std::string beginning_;                                 ///< of the input
    std::array<Count, 2 * diagnostic_kind_count> counts_{}; ///< of the input, and of the reference
    std::size_t errors_ = 0;
};

} // namespace rotconv::cli
