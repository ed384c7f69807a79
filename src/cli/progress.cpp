#include "progress.hpp"

#include <unistd.h>

#include "../stream/fmt.hpp"

namespace rotconv::cli {
namespace {

constexpr double large = 1e6; ///< bytes
constexpr auto interval = std::chrono::milliseconds(200);

void show(std::string_view text) { static_cast<void>(stream::File(STDERR_FILENO).write(text)); }

} // namespace

Progress::Progress(stream::File& file, bool wanted) : file_(&file) {
    if (wanted && ::isatty(STDERR_FILENO) != 0 && static_cast<double>(file.size()) >= large) {
        size_ = static_cast<double>(file.size());
        next_ = Clock::now() + interval;
    }
}

Progress::~Progress() {
    if (shown_) {
        show("\033[K");
    }
}

std::ptrdiff_t Progress::read(std::span<char> to) {
    const auto count = file_->read(to);
    if (count > 0 && size_ > 0.0) {
        done_ += static_cast<double>(count);
        if (const auto now = Clock::now(); now >= next_) {
            next_ = now + interval;
            shown_ = true;
            show(fmt::format("rotconv: {:.0f} %\r", 100.0 * done_ / size_)); // a message overwrites it
        }
    }
    return count;
}

} // namespace rotconv::cli
