#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../stream/delimiter.hpp"
#include "../stream/file.hpp"

/// What the beginning of a file tells of its rows, for messages.
namespace rotconv::cli {

/// The first row most of whose fields are numbers.
struct FirstLook {
    std::size_t line = 0; ///< 0: there is none
    stream::Delimiter delimiter = stream::Delimiter::blanks();
    std::vector<std::string> fields;
    std::vector<std::string> names; ///< of as many fields, from the line before; '#' and such at its beginning left out
};

[[nodiscard]] FirstLook look_at(std::string_view beginning);

/// The beginning of a regular file; empty of anything else.
[[nodiscard]] std::string beginning_of(const std::string& path);

/// A word for a line at which reading stopped, and what leaves it out or reads it: the end of a message, or nothing.
/// `count`: the fields of a row, where no columns are selected. `file`: to be named in a command.
[[nodiscard]] std::string advice(std::string_view beginning, std::size_t line, std::size_t count,
                                 const std::string& file);

/// Passes on what it reads, and keeps what came first.
class KeptBeginning final : public stream::Source {
public:
    explicit KeptBeginning(stream::Source& source) noexcept : source_(&source) {}

    std::ptrdiff_t read(std::span<char> to) override;
    [[nodiscard]] bool is_ready() const override { return source_->is_ready(); }

    /// Up to 64 KiB of the first piece. It does not change any more once that has been read.
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    stream::Source* source_;
    std::string text_;
    bool has_read_ = false;
};

} // namespace rotconv::cli
