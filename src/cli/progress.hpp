#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace rotconv::cli {

/// A line on a terminal that says how far work of more than a second is, until it is cleared.
class Progress {
public:
    /// @param size bytes of the whole; 0: that is not known
    /// @param row bytes of a row; 0: a row is a line
    Progress(bool is_shown, std::size_t size, std::size_t row) : is_shown_(is_shown), size_(size), row_(row) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    /// Adds bytes that have been read.
    void add(std::string_view bytes);
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds before_first{1000};
    static constexpr std::chrono::milliseconds interval{200};

    bool is_shown_;
    bool has_line_ = false;
    std::size_t size_;
    std::size_t row_;
    std::size_t done_ = 0; ///< bytes
    std::size_t rows_ = 0;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_ + before_first;
};

} // namespace rotconv::cli
