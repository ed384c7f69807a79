#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "number_text.hpp"

namespace rotconv::stream {

/// Appends the text as a JSON string; bytes that are not UTF-8 become U+FFFD.
void append_json_string(Buffer& to, std::string_view text);
[[nodiscard]] std::string json_string(std::string_view text);

/// Whether a text is a number of JSON (RFC 8259), except integers beyond 2^53, which readers would round.
[[nodiscard]] bool is_json_number(std::string_view text) noexcept;

/// The keys of a row's fields in a JSON object, none of them twice: the header's names, otherwise 1-based indices.
class JsonKeys {
public:
    /// Keys without a header.
    JsonKeys() = default;
    /// @param names the header's
    /// @param taken the result's keys, in quotes
    /// @param is_written whether a field is written
    JsonKeys(const std::vector<std::string>& names, const std::vector<std::string>& taken,
             const std::function<bool(std::size_t)>& is_written);

    /// Appends the key of field `at`, from 0, of a row of `count` fields, with its quotes.
    void append_to(Buffer& to, std::size_t at, std::size_t count) const;

private:
    std::vector<std::string> keys_; ///< with their quotes; an empty key stands for the index
};

} // namespace rotconv::stream
