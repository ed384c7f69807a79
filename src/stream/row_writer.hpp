#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "header_line.hpp"
#include "io_block.hpp"
#include "job.hpp"
#include "layout.hpp"
#include "options.hpp"

namespace rotconv::stream {

/// One converted row: what it was and what it became.
struct ConvertedRow {
    Line line;
    std::size_t number = 0; ///< of the line
    std::span<const std::string_view> fields;
    std::span<const double> result; ///< nan where the row failed
    const RowReport* report = nullptr;
    bool failed = false;
    std::string_view answer{};  ///< its name, of several to the row
    std::string_view partner{}; ///< what follows of the row with which it is paired
};

/// The columns of the result, and of its diagnostics where those are shown. They are views into the arguments.
[[nodiscard]] std::vector<std::string_view> result_columns(const Options& options, const Layout& layout);

/// The header with the result's columns in their place.
void write_header(Buffer& to, const Options& options, const Layout& layout, const HeaderLine& header);
/// The header of an input that has none, under HeaderMode::add: other columns are named by their index.
void write_added_header(Buffer& to, const Options& options, const Layout& layout);

/// Writes converted rows in the format of the options.
class RowWriter {
public:
    RowWriter(const Options& options, const Layout& layout);

    void write(Buffer& to, const ConvertedRow& row) const;
    /// Rows without other columns of the output than the result's, which stands in the place of the row's numbers, or
    /// at its end; each answer to them. `results` are those of all rows at hand.
    void write(Buffer& to, std::span<const Row> rows, std::span<const double> results) const;
    /// Whether such rows are all that is written where there is no failure.
    [[nodiscard]] bool writes_results_alone() const noexcept { return is_plain_ && outer_angles_.empty(); }

private:
    void write_csv(Buffer& to, const ConvertedRow& row) const;
    void write_json(Buffer& to, const ConvertedRow& row) const;
    void write_pretty(Buffer& to, const ConvertedRow& row) const;
    void write_f64(Buffer& to, const ConvertedRow& row) const;
    /// The result and, if asked for, the four diagnostic columns.
    void write_result(Buffer& to, const ConvertedRow& row) const;
    void write_number(Buffer& to, double value, std::size_t column) const;
    /// Where answers have names, theirs stands before this number.
    [[nodiscard]] bool stands_name_before(std::size_t column) const noexcept {
        return !options_->operation->answers.empty() && column + 1 == options_->operation->names.size();
    }

    const Options* options_;
    const Layout* layout_;
    std::vector<std::string> json_keys_; ///< of the result and the diagnostic columns, each with what stands around it
    /// The range of outer Euler angles, the open end of which rounded numbers may show.
    struct OuterAngles {
        std::size_t first = 0; ///< their columns...
        std::size_t third = 0;
        double open_end = 0.0;
        double half_a_digit = 0.0;     ///< the last that is printed of it
        std::string open_end_text{};   ///< as it would be printed...
        std::string closed_end_text{}; ///< ...and the other end, which is
    };
    [[nodiscard]] OuterAngles outer_angles(const Spec& spec, std::size_t first) const;
    void write_attitudes(Buffer& to, const ConvertedRow& row) const;

    std::vector<OuterAngles> outer_angles_; ///< where numbers are rounded and have such a range
    bool is_plain_;                         ///< text, and nothing but the result is added to it
};

} // namespace rotconv::stream
