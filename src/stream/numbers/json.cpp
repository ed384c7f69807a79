#include "json.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "../bytes/utf8.hpp"

namespace rotconv::stream {
namespace {

/// Whether the key, in quotes, is not the index of a field other than `at` in a row of `count` fields.
bool is_free(std::string_view key, std::size_t at, std::size_t count) noexcept {
    std::size_t index = 0;
    const char* const end = key.data() + key.size() - 1;
    const auto [stop, error] = std::from_chars(key.data() + 1, end, index);
    const bool is_index = error == std::errc{} && stop == end && key[1] != '0';
    return !is_index || index == at + 1 || index > count;
}

} // namespace

std::string json_string(std::string_view text) {
    Buffer string;
    append_json_string(string, text);
    return fmt::to_string(string);
}

void append_json_string(Buffer& to, std::string_view text) {
    to.push_back('"');
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char c = text[0];
        if (length == 0) {
            append(to, "\xEF\xBF\xBD");
        } else if (c == '"' || c == '\\') {
            to.push_back('\\');
            to.push_back(c);
        } else if (static_cast<unsigned char>(c) < 0x20U) {
            fmt::format_to(std::back_inserter(to), "\\u{:04x}", static_cast<unsigned>(c));
        } else {
            append(to, text.substr(0, length));
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    to.push_back('"');
}

bool is_json_number(std::string_view text) noexcept {
    constexpr std::string_view largest = "9007199254740992"; // 2^53
    /// Removes up to `most` of these characters from the beginning of the text.
    const auto take = [&text](std::string_view any_of, std::size_t most) {
        const std::string_view taken = text.substr(0, std::min(text.find_first_not_of(any_of), most));
        text.remove_prefix(taken.size());
        return taken;
    };
    const auto take_digits = [&] { return take("0123456789", text.size()); };
    take("-", 1);
    const std::string_view whole = take_digits();
    if (whole.empty() || (whole.size() > 1 && whole.front() == '0')) {
        return false;
    }
    if (text.empty()) {
        return whole.size() < largest.size() || (whole.size() == largest.size() && whole <= largest);
    }
    if (!take(".", 1).empty() && take_digits().empty()) {
        return false;
    }
    if (!take("eE", 1).empty()) {
        take("+-", 1);
        return !take_digits().empty() && text.empty();
    }
    return text.empty();
}

JsonKeys::JsonKeys(const std::vector<std::string>& names, const std::vector<std::string>& taken,
                   const std::function<bool(std::size_t)>& is_written)
    : keys_(names.size()) {
    // Compared as they are written: names that differ in bytes that are not UTF-8 may become the same.
    std::unordered_set<std::string> used(taken.begin(), taken.end());
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string key = json_string(names[i]);
        if (!names[i].empty() && is_written(i) && is_free(key, i, names.size()) && used.insert(key).second) {
            keys_[i] = std::move(key);
        }
    }
}

void JsonKeys::append_to(Buffer& to, std::size_t at, std::size_t count) const {
    if (at < keys_.size() && !keys_[at].empty() && (count <= keys_.size() || is_free(keys_[at], at, count))) {
        append(to, keys_[at]);
    } else {
        fmt::format_to(std::back_inserter(to), "\"{}\"", at + 1);
    }
}

} // namespace rotconv::stream
