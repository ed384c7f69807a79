#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "stream/bytes/file.hpp"

/// Hands out a text in pieces of given sizes, again and again.
class Pieces final : public rotconv::stream::Source {
public:
    Pieces(std::string text, std::vector<std::size_t> sizes) : text_(std::move(text)), sizes_(std::move(sizes)) {}
    std::ptrdiff_t read(std::span<char> to) override {
        const std::size_t count = std::min({sizes_[next_++ % sizes_.size()], to.size(), text_.size() - at_});
        std::copy_n(text_.data() + at_, count, to.data());
        at_ += count;
        return static_cast<std::ptrdiff_t>(count);
    }

private:
    std::string text_;
    std::vector<std::size_t> sizes_;
    std::size_t at_ = 0;
    std::size_t next_ = 0;
};
