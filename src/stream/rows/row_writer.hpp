#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../beginning/header_line.hpp"
#include "../bytes/io_block.hpp"
#include "../job.hpp"
#include "../options.hpp"
#include "layout.hpp"

namespace rotconv::stream {

/// The figure of a diagnostic of a row, from the sensitivity of its result or of the part that has it.
[[nodiscard]] double figure_of(const RowReport& report, const Sensitivity& sensitivity, DiagnosticKind kind) noexcept;

/// Visits the diagnostics of a row with their figures, in order of kind.
template <class Visit> void for_each_diagnostic(const RowReport& report, std::size_t line, const Visit& visit) {
    if (report.diagnostics.empty()) {
        return;
    }
    for (const DiagnosticKind kind : all_diagnostic_kinds) {
        if (report.diagnostics.has(kind)) {
            const auto part = std::ranges::find_if(
                report.parts, [kind](const PartReport& each) { return each.diagnostics.has(kind); });
            const Sensitivity& sensitivity = part != report.parts.end() ? part->sensitivity : report.sensitivity;
            visit(Diagnostic{{line}, kind, figure_of(report, sensitivity, kind)});
        }
    }
}

/// One row and its result.
struct ConvertedRow {
    Line line;
    std::size_t number = 0; ///< the line's
    std::span<const std::string_view> fields;
    std::span<const double> result; ///< nan if the row failed
    const RowReport* report = nullptr;
    bool failed = false;
    std::string_view partner{}; ///< the fields partner_names, each after a delimiter
};

/// The columns of the result as keys of JSON, in quotes. `delimiter`: that of the header.
[[nodiscard]] std::vector<std::string> result_keys(const Options& options, const Layout& layout, Delimiter delimiter);

/// Writes the header with the result's columns in their place.
void write_header(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& header);
/// Writes a line of units below the header, with the result's in their place.
void write_units(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& units);
/// Writes a header for an input that has none: other columns are named by their index.
void write_added_header(Buffer& to, const Options& options, const Layout& layout);

/// Writes converted rows in the format of the options.
class RowWriter {
public:
    RowWriter(const Options& options, const Layout& layout);

    void write(Buffer& to, const ConvertedRow& row) const;
    /// Writes rows that were scanned, one after the other, to which the output adds only the result, in the place of
    /// the row's numbers or at its end. `results` are those of all rows at hand.
    void write(Buffer& to, std::span<const Row> rows, std::span<const double> results) const;
    /// Whether all rows that do not fail are such rows, but those near an open end.
    [[nodiscard]] bool writes_results_alone() const noexcept { return is_plain_; }
    [[nodiscard]] bool has_open_ends() const noexcept { return !open_ends_.empty(); }
    /// Whether a number may be rounded to the open end of its range.
    [[nodiscard]] bool is_near_open_end(std::span<const double> result) const noexcept;
    /// Writes a number of a result.
    void write_number(Buffer& to, double value, std::size_t column) const;

private:
    void write_csv(Buffer& to, const ConvertedRow& row) const;
    void write_json(Buffer& to, const ConvertedRow& row) const;
    /// Writes the numbers of a row, each after its key.
    void write_json_members(Buffer& to, std::span<const double> numbers) const;
    /// Writes the numbers of each SPEC after its text.
    void write_json_parts(Buffer& to, std::span<const double> numbers) const;
    void write_json_number(Buffer& to, double number, std::size_t column) const;
    void write_pretty(Buffer& to, const ConvertedRow& row) const;
    void write_f64(Buffer& to, const ConvertedRow& row) const;
    const Options* options_;
    const Layout* layout_;
    std::vector<std::string> json_keys_; ///< of the result and the diagnostic columns, in quotes, ", " to ": "
    std::size_t size_of_json_keys_ = 0;
    /// A number whose range has an open end: if it is rounded to that end, the other one is written.
    struct OpenEnd {
        std::size_t number = 0; ///< its index in a result
        double end = 0.0;
        double half_a_digit = 0.0; ///< half of the last digit that is printed
        std::string text{};        ///< the end as it would be printed
        std::string other{};       ///< printed instead
    };
    /// Adds the open ends of a part whose numbers begin with that of the index.
    void add_open_ends(const ResultPart& part, std::size_t first);
    /// Writes an attitude with its label, a matrix in three lines.
    static void write_attitude(Buffer& to, const Spec& spec, std::span<const std::string> texts, std::string_view label,
                               std::size_t label_width, std::string_view names);

    std::vector<OpenEnd> open_ends_; ///< if numbers are rounded
    bool is_plain_;                  ///< nothing but the result is added to a row that is copied
};

} // namespace rotconv::stream
