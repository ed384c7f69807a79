#include "json_keys.hpp"

#include <charconv>
#include <iterator>
#include <unordered_set>

#include "json_string.hpp"

namespace rotconv::stream {
namespace {

std::string in_quotes(std::string_view text) {
    Buffer key;
    append_json_string(key, text);
    return fmt::to_string(key);
}

} // namespace

JsonKeys::JsonKeys(const std::vector<std::string>& names, const std::vector<std::string_view>& taken,
                   const std::function<bool(std::size_t)>& is_written) {
    // Compared as they are written: names that differ in bytes that are not UTF-8 may become the same.
    std::unordered_set<std::string> used;
    for (const std::string_view key : taken) {
        used.insert(in_quotes(key));
    }
    keys_.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string key = in_quotes(names[i]);
        if (!names[i].empty() && is_written(i) && may_stand(key, i, names.size()) && used.insert(key).second) {
            keys_[i] = std::move(key);
        }
    }
}

void JsonKeys::append_to(Buffer& to, std::size_t at, std::size_t count) const {
    const bool has_name =
        at < keys_.size() && !keys_[at].empty() && (count <= keys_.size() || may_stand(keys_[at], at, count));
    if (has_name) {
        append(to, keys_[at]);
    } else {
        fmt::format_to(std::back_inserter(to), "\"{}\"", at + 1);
    }
}

bool JsonKeys::may_stand(std::string_view key, std::size_t at, std::size_t count) noexcept {
    std::size_t index = 0;
    const char* const end = key.data() + key.size() - 1;
    const auto [stop, error] = std::from_chars(key.data() + 1, end, index);
    const bool is_index = error == std::errc{} && stop == end && key[1] != '0';
    return !is_index || index == at + 1 || index > count;
}

} // namespace rotconv::stream
