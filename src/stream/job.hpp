#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "bytes/io_block.hpp"
#include "event.hpp"
#include "rows/layout.hpp"
#include "rows/row_reader.hpp"

namespace rotconv::stream {

/// Pairs of rows, in the order of the stream.
struct PairBlock {
    ReadRows read;                                    ///< in pairs, or alone: not to be paired
    std::vector<std::shared_ptr<const Buffer>> texts; ///< hold the rows
    std::size_t bytes = 0;                            ///< size of the rows

    void clear() noexcept {
        read.clear();
        texts.clear();
        bytes = 0;
    }
};

/// A block on its way from the input to the output.
struct Job {
    IoBlock block;
    PairBlock pairs;  ///< instead of a block, if two streams are read side by side
    RowWidth width{}; ///< see JobReader
    Output output;
    bool ran_in_order = false; ///< see Ordered
    bool done = false;

    /// The bytes of its lines.
    [[nodiscard]] std::size_t size() const noexcept { return block.text.size() + pairs.bytes; }
    [[nodiscard]] bool has_rows() const noexcept { return !block.text.empty() || !pairs.read.rows.empty(); }
};

/// The source of a run's jobs. Used by one thread at a time.
class JobReader {
public:
    JobReader() = default;
    JobReader(const JobReader&) = delete;
    JobReader& operator=(const JobReader&) = delete;
    virtual ~JobReader() = default;

    /// Reads the next job, and adds the lines before the first data row, and rows without a partner, to its output.
    /// @return false if no job comes after it
    virtual bool read(Job& job) = 0;
    /// Whether read() would not have to wait.
    [[nodiscard]] virtual bool is_ready() const = 0;
    /// To be called at the end of a run, `at_end` of the stream: adds lines that still wait for a data row.
    virtual void finish(Output& output, bool at_end) = 0;
    [[nodiscard]] virtual std::optional<StreamError> error() const = 0;
    /// The layout of a stream; null if there is no reference.
    [[nodiscard]] virtual const Layout* layout(Side side) const = 0;
    /// The row width of blocks, as far as it is known after the last job.
    [[nodiscard]] virtual RowWidth width() const { return {}; }
    [[nodiscard]] virtual PairingStats keys() const { return {}; }
};

} // namespace rotconv::stream
