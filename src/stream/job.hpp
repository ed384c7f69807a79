#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "io_block.hpp"
#include "layout.hpp"

namespace rotconv::stream {

/// A row of a stream, perhaps with the row of the reference that it is compared with.
struct Row {
    static constexpr std::size_t no_error = static_cast<std::size_t>(-1);

    // Without a constructor all bytes would be cleared first, which takes longer than the rest.
    explicit Row(const Line& line_ = {}, std::size_t number_ = 0) noexcept : line(line_), number(number_) {}

    Line line;
    std::size_t number; ///< of the line; 0 where there is only the reference's
    std::string_view reference{};
    std::size_t reference_number = 0; ///< 0: there is none
    std::string_view later{};         ///< the row of the reference after that one, where both count...
    std::size_t later_number = 0;     ///< ...else 0
    double fraction = 0.0;            ///< how far the row is on the way between them
    bool passes = false;              ///< blank or comment: goes out as it is
    std::size_t error = no_error;     ///< which one, of a row without numbers
    // Of a row that is read:
    std::string_view numbers{}; ///< where they stand, if it was scanned: its fields were not looked for
    std::size_t first_field = 0;
    std::size_t field_count = 0;
    std::size_t index = 0; ///< among the rows with numbers

    [[nodiscard]] bool is_scanned() const noexcept { return numbers.data() != nullptr; }
    [[nodiscard]] bool has_numbers() const noexcept { return !passes && error == no_error; }
};

/// Pairs of rows, in the order of the stream.
struct PairBlock {
    std::vector<Row> rows;                            ///< in pairs or, with an error of the key, alone
    std::vector<RowError> errors;                     ///< of those rows
    std::vector<std::shared_ptr<const Buffer>> texts; ///< in which the rows stand, with RowReader::room_behind
    std::size_t bytes = 0;                            ///< of the rows

    void clear() noexcept {
        rows.clear();
        errors.clear();
        texts.clear();
        bytes = 0;
    }
};

/// A block on its way from the input to the output.
struct Job {
    IoBlock block;
    std::string_view rest;            ///< its data rows, not yet converted...
    std::size_t line = 1;             ///< ...and the line of the first
    PairBlock pairs;                  ///< in their place where two streams are read side by side
    std::array<RowWidth, 2> widths{}; ///< see JobReader
    Output output;
    bool had_its_turn = false; ///< see InTurn
    bool done = false;

    /// Bytes of what was read.
    [[nodiscard]] std::size_t size() const noexcept { return block.text.size() + pairs.bytes; }
};

/// Where a run's jobs come from. Used by one thread at a time.
class JobReader {
public:
    JobReader() = default;
    JobReader(const JobReader&) = delete;
    JobReader& operator=(const JobReader&) = delete;
    virtual ~JobReader() = default;

    /// Reads the next job, and adds to its output what stands before the first data row.
    /// @return false where nothing comes after it
    virtual bool read(Job& job) = 0;
    /// Whether read() would not have to wait.
    [[nodiscard]] virtual bool is_ready() const = 0;
    /// To be called at the end of a run without a data row, `at_end` of the stream: adds what still waits.
    virtual void finish(Output& output, bool at_end) = 0;
    [[nodiscard]] virtual std::optional<StreamError> error() const = 0;
    [[nodiscard]] virtual const Layout& layout() const = 0;
    /// Of the other stream, if there are two.
    [[nodiscard]] virtual const Layout* reference_layout() const { return nullptr; }
    /// Of the rows of the stream, and of the reference, as far as it is known after the last job.
    [[nodiscard]] virtual std::array<RowWidth, 2> widths() const = 0;
    /// Of the stream, and of the reference.
    [[nodiscard]] virtual std::array<Unpaired, 2> unpaired() const { return {}; }
    [[nodiscard]] virtual KeysMet keys() const { return {}; }
};

} // namespace rotconv::stream
