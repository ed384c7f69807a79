// file.hpp on POSIX.

#include "file.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sched.h>
#endif

namespace rotconv::stream {
namespace {

/// Waits until a descriptor has room or bytes, or for that many milliseconds; -1: without end.
/// @return 0 if it has none
int wait_for(int descriptor, short events, int timeout) noexcept {
    pollfd waiting{descriptor, events, 0};
    int count = 0;
    do {
        count = ::poll(&waiting, 1, timeout);
    } while (count < 0 && errno == EINTR);
    return count;
}

} // namespace

void guard_standard_descriptors() noexcept {
    for (const auto& [descriptor, mode] :
         {std::pair{STDIN_FILENO, O_WRONLY}, std::pair{STDOUT_FILENO, O_RDONLY}, std::pair{STDERR_FILENO, O_WRONLY}}) {
        if (::fcntl(descriptor, F_GETFD) == -1 && errno == EBADF) {
            ::open("/dev/null", mode); // takes the lowest free number, which is this one
        }
    }
}

std::size_t processors() noexcept {
#ifdef __linux__
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
        return static_cast<std::size_t>(CPU_COUNT(&allowed));
    }
#endif
    return std::max(1U, std::thread::hardware_concurrency());
}

File::File(const char* path, Mode mode) noexcept
    : descriptor_(mode == Mode::read ? ::open(path, O_RDONLY | O_CLOEXEC)
                                     : ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
      owned_(true) {}

int File::why_unreadable(const char* path) noexcept {
    struct stat status {};
    if (std::strcmp(path, "-") == 0) {
        return 0;
    }
    if (::access(path, R_OK) != 0 || ::stat(path, &status) != 0) {
        return errno;
    }
    return S_ISDIR(status.st_mode) ? EISDIR : 0;
}

bool File::is_regular() const noexcept {
    struct stat status {};
    return ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
}

bool File::is_regular(const char* path) noexcept {
    struct stat status {};
    return ::stat(path, &status) == 0 && S_ISREG(status.st_mode);
}

std::string File::name_of_input() { // Linux has these links
    std::string name(4096, '\0');
    std::string folder(4096, '\0');
    const ssize_t size = ::readlink("/proc/self/fd/0", name.data(), name.size());
    if (size <= 0 || !is_regular("/proc/self/fd/0") || ::getcwd(folder.data(), folder.size()) == nullptr) {
        return {};
    }
    name.resize(static_cast<std::size_t>(size));
    folder.resize(folder.find('\0'));
    return name.starts_with(folder + '/') ? name.substr(folder.size() + 1) : name;
}

const std::string& File::lines_of_pipe() {
    static const std::string lines = [] {
        constexpr auto longest = std::chrono::milliseconds(300);
        const auto end = std::chrono::steady_clock::now() + longest;
        struct stat status {};
        std::string text(std::size_t{64} << 10U, '\0');
        std::size_t size = 0;
        bool is_whole = ::fstat(STDIN_FILENO, &status) != 0 || !S_ISFIFO(status.st_mode);
        while (!is_whole && size < text.size()) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
            if (left.count() <= 0 || wait_for(STDIN_FILENO, POLLIN, static_cast<int>(left.count())) <= 0) {
                break;
            }
            const ssize_t count = ::read(STDIN_FILENO, text.data() + size, text.size() - size);
            if (count < 0) {
                break;
            }
            is_whole = count == 0;
            size += static_cast<std::size_t>(count);
        }
        text.resize(size);
        text.resize(is_whole ? size : text.rfind('\n') + 1);
        return text;
    }();
    return lines;
}

bool File::shares_bytes(const char* path) const noexcept {
    struct stat mine {};
    struct stat other {};
    const bool is_stdin = std::strcmp(path, "-") == 0;
    const int error = is_stdin ? ::fstat(STDIN_FILENO, &other) : ::stat(path, &other);
    const bool is_same =
        error == 0 && ::fstat(descriptor_, &mine) == 0 && mine.st_dev == other.st_dev && mine.st_ino == other.st_ino;
    const bool is_read_once = S_ISFIFO(mine.st_mode) || S_ISSOCK(mine.st_mode) || ::isatty(descriptor_) != 0;
    return (is_stdin && descriptor_ == STDIN_FILENO) || (is_same && is_read_once);
}

std::size_t File::size() const noexcept {
    struct stat status {};
    return is_regular() && ::fstat(descriptor_, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

void File::widen() const noexcept {
#ifdef F_SETPIPE_SZ // Linux
    constexpr int size = 1 << 20U;
    ::fcntl(descriptor_, F_SETPIPE_SZ, size); // fails on anything else, and harms nobody
#endif
}

int File::close() noexcept {
    if (!owned_ || descriptor_ < 0) {
        return 0;
    }
    const int result = ::close(descriptor_);
    descriptor_ = -1;
    return result == 0 || errno == EINTR ? 0 : errno;
}

std::ptrdiff_t File::read(std::span<char> to) {
    while (true) {
        const auto count = ::read(descriptor_, to.data(), to.size());
        if (count >= 0 || (errno != EINTR && errno != EAGAIN)) {
            return count;
        }
        if (errno == EAGAIN) {
            wait_for(descriptor_, POLLIN, -1);
        }
    }
}

bool File::is_ready_within(std::chrono::milliseconds time) const {
    return wait_for(descriptor_, POLLIN, static_cast<int>(time.count())) != 0;
}

int File::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const auto count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN) {
            wait_for(descriptor_, POLLOUT, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

bool OutputFile::is_same(const File& input) const noexcept {
    struct stat mine {};
    struct stat theirs {};
    const int error = file_ ? ::fstat(file_->descriptor(), &mine) : ::stat(path_.c_str(), &mine);
    return error == 0 && ::fstat(input.descriptor(), &theirs) == 0 && S_ISREG(mine.st_mode) &&
           mine.st_dev == theirs.st_dev && mine.st_ino == theirs.st_ino;
}

} // namespace rotconv::stream
