#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "file.hpp"

namespace rotconv::stream {

/// A source whose first row, neither blank nor a comment, can be seen before it is read.
class FirstRow final : public Source {
public:
    explicit FirstRow(Source& source) noexcept : source_(&source) {}

    /// Waits for the row; empty where there is none, or none in the first 4 MiB. Valid until something is read.
    [[nodiscard]] std::string_view text();
    /// Its line.
    [[nodiscard]] std::size_t line() const noexcept { return line_; }

    std::ptrdiff_t read(std::span<char> to) override;
    [[nodiscard]] bool is_ready() const override { return read_ < held_.size() || source_->is_ready(); }

private:
    /// Looks on among the lines that are held; the last one counts where it is whole.
    [[nodiscard]] std::string_view find(bool is_whole);

    Source* source_;
    std::string held_;       ///< what has been seen...
    std::size_t read_ = 0;   ///< ...and how much of it has been read
    std::size_t looked_ = 0; ///< bytes of the lines that are not the row
    std::size_t line_ = 1;
};

} // namespace rotconv::stream
