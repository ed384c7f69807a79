#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "event.hpp"
#include "io_block.hpp"

namespace rotconv::stream {

/// A row of a stream and the one of the reference that it is compared with; or a row that is no part of a pair.
struct PairedRow {
    static constexpr std::size_t no_error = static_cast<std::size_t>(-1);

    Line row;
    std::size_t number = 0; ///< of its line; 0 where there is only the reference's
    Line reference{};
    std::size_t reference_number = 0;
    bool passed = false;          ///< blank or comment: goes out as it is
    std::size_t error = no_error; ///< in PairBlock::errors, of a row whose key is at fault
};

/// Pairs of rows, in the order of the stream.
struct PairBlock {
    std::vector<PairedRow> rows;
    std::vector<RowError> errors;
    std::vector<std::shared_ptr<const IoBlock>> texts; ///< in which the rows stand
    std::size_t bytes = 0;                             ///< of the rows

    void clear() noexcept {
        rows.clear();
        errors.clear();
        texts.clear();
        bytes = 0;
    }
};

/// Rows of a stream that are in no pair.
struct Unpaired {
    std::size_t rows = 0;
    std::size_t first_line = 0; ///< of the first of them
};

/// A block on its way from the input to the output.
struct Job {
    IoBlock block;
    std::string_view rest; ///< its data rows, not yet converted...
    std::size_t line = 1;  ///< ...and the line of the first
    PairBlock pairs;       ///< in their place where two streams are read side by side
    Output output;
    std::size_t turn = 0; ///< how many before it have data rows
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
    /// To be called at the end of a run without a data row.
    virtual void finish(Output& output) = 0;
    [[nodiscard]] virtual std::optional<StreamError> error() const = 0;
};

} // namespace rotconv::stream
