#include "first_row.hpp"

#include <algorithm>
#include <cstring>

#include "io_block.hpp"

namespace rotconv::stream {

std::string_view FirstRow::text() {
    while (true) {
        const std::size_t before = held_.size();
        held_.resize(before + IoBlockReader::largest_block);
        const std::ptrdiff_t count = source_->read(std::span(held_).subspan(before));
        held_.resize(before + static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0)));
        const std::string_view found = find(count <= 0);
        if (!found.empty() || count <= 0 || held_.size() - looked_ > IoBlockReader::longest_line) {
            return found;
        }
    }
}

std::string_view FirstRow::find(bool is_whole) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    std::string_view rest = std::string_view(held_).substr(looked_);
    while (!rest.empty() && (is_whole || rest.find('\n') != std::string_view::npos)) {
        std::string_view text = next_line(rest).text;
        if (looked_ == 0 && text.starts_with(mark)) {
            text.remove_prefix(mark.size());
        }
        if (!is_blank(text) && !is_comment(text)) {
            return text;
        }
        looked_ = held_.size() - rest.size();
        ++line_;
    }
    return {};
}

std::ptrdiff_t FirstRow::read(std::span<char> to) {
    if (read_ == held_.size()) {
        return source_->read(to);
    }
    const std::size_t count = std::min(to.size(), held_.size() - read_);
    std::memcpy(to.data(), held_.data() + read_, count);
    read_ += count;
    return static_cast<std::ptrdiff_t>(count);
}

} // namespace rotconv::stream
