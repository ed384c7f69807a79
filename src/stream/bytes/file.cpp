// What is the same on all systems: see posix_file.cpp and windows_file.cpp.

#include "file.hpp"

#include <cerrno>
#include <utility>

namespace rotconv::stream {

std::ptrdiff_t TextSource::read(std::span<char> to) {
    const std::size_t count = text_.copy(to.data(), to.size(), done_);
    done_ += count;
    return static_cast<std::ptrdiff_t>(count);
}

File::~File() { close(); }

bool File::is_ready() const { return is_ready_within({}); }

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
    if (path_ == "-") {
        file_.emplace(1, true);
        file_->widen();
    }
}

int OutputFile::open() {
    if (!file_) {
        file_.emplace(path_.c_str(), File::Mode::write);
        if (!file_->is_open()) {
            return errno;
        }
        file_->widen();
    }
    return 0;
}

int OutputFile::write(std::string_view bytes) {
    if (bytes.empty()) {
        return 0;
    }
    const int error = open();
    return error == 0 ? file_->write(bytes) : error;
}

int OutputFile::finish(bool is_whole) {
    const int error = is_whole ? open() : 0;
    return error == 0 && file_ ? file_->close() : error;
}

} // namespace rotconv::stream
