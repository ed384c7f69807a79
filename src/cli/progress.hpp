#pragma once

#include <chrono>

#include "../stream/file.hpp"

namespace rotconv::cli {

/// Reads a file and shows on stderr how much of it is read, where that is a terminal and the file a large one.
class Progress final : public stream::Source {
public:
    Progress(stream::File& file, bool wanted);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() override;

    std::ptrdiff_t read(std::span<char> to) override;
    [[nodiscard]] bool is_ready() const override { return file_->is_ready(); }

private:
    using Clock = std::chrono::steady_clock;

    stream::File* file_;
    double size_ = 0.0; ///< bytes; 0 where nothing is shown
    double done_ = 0.0;
    Clock::time_point next_;
    bool shown_ = false;
};

} // namespace rotconv::cli
