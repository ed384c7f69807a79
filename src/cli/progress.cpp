#include "progress.hpp"

#include <algorithm>
#include <utility>

#include <unistd.h>

#include "../stream/bytes/file.hpp"
#include "../stream/numbers/fmt.hpp"

namespace rotconv::cli {

void Progress::add(std::string_view bytes) {
    if (!is_shown_) {
        return;
    }
    done_ += bytes.size();
    rows_ = row_ > 0 ? done_ / row_ : rows_ + static_cast<std::size_t>(std::ranges::count(bytes, '\n'));
    if (const auto now = Clock::now(); now >= next_) {
        next_ = now + interval;
        has_line_ = true;
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        const double part = size_ > 0 ? static_cast<double>(done_) / static_cast<double>(size_) : 0.0;
        const std::string percent = size_ > 0 ? fmt::format("{:.0f} %, ", 100.0 * part) : "";
        const std::string left = part > 0.0 ? fmt::format(", {:.0f} s left", seconds / part - seconds) : "";
        static_cast<void>(stream::File(STDERR_FILENO)
                              .write( // a message overwrites it
                                  fmt::format("rotconv: {}{} rows, {:.3g} rows/s{}\033[K\r", percent, rows_,
                                              static_cast<double>(rows_) / seconds, left)));
    }
}

void Progress::clear() {
    if (std::exchange(has_line_, false)) {
        static_cast<void>(stream::File(STDERR_FILENO).write("\033[K"));
    }
}

} // namespace rotconv::cli
