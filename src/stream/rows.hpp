#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "layout.hpp"
#include "lines.hpp"
#include "row_text.hpp"

namespace rotconv::stream {

/// Turns blocks of rows into their output. What a block becomes depends on the block, the options and the layout alone,
/// so that several transformers may work on the blocks of one stream.
class RowTransformer {
public:
    RowTransformer(const Options& options, const Layout& layout);

    /// Adds what the rows of `text`, whole lines of which the first is line `line`, become.
    void transform(std::string_view text, std::size_t line, Output& output);

private:
    static constexpr std::size_t batch = 128;
    static constexpr std::size_t no_fault = static_cast<std::size_t>(-1);

    struct Row {
        Line line;
        std::size_t number = 0;      ///< of the line
        bool passed = false;         ///< blank or comment: goes out as it is
        std::size_t first_field = 0; ///< in fields_
        std::size_t field_count = 0;
        std::size_t fault = no_fault; ///< in faults_
    };

    void gather(std::string_view& text, std::size_t& line);
    void read_row(Row& row);
    /// The fields that hold the numbers, parted by the delimiter.
    [[nodiscard]] std::string selected_text(const Row& row) const;
    void write(Output& output);
    void write_row(const Row& row, std::size_t index, Output& output);
    void note_fault(Row& row, RowFault fault);

    const Options* options_;
    const Layout* layout_;
    RowText row_text_;
    // One batch, reused: nothing is allocated per row once they have grown.
    std::vector<Row> rows_;
    std::vector<std::string_view> fields_;
    std::vector<RowFault> faults_;
    std::vector<double> numbers_;
    std::vector<double> results_;
    std::vector<Report> reports_;
};

} // namespace rotconv::stream
