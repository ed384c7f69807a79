// file.hpp on Windows: descriptors of the C library in binary mode, paths in UTF-8.

#include "file.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <thread>

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX // libstdc++ defines it
#define NOMINMAX
#endif
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

namespace rotconv::stream {
namespace {

constexpr std::size_t most_bytes = 1U << 20U; ///< of a call

std::wstring wide(const char* path) {
    std::wstring text(static_cast<std::size_t>(::MultiByteToWideChar(CP_UTF8, 0, path, -1, nullptr, 0)), L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, path, -1, text.data(), static_cast<int>(text.size()));
    return text;
}

HANDLE handle_of(int descriptor) noexcept { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

/// FILE_TYPE_DISK, FILE_TYPE_PIPE or FILE_TYPE_CHAR.
DWORD type_of(int descriptor) noexcept { return ::GetFileType(handle_of(descriptor)); }

unsigned size_of_call(std::size_t size) noexcept { return static_cast<unsigned>(std::min(size, most_bytes)); }

} // namespace

void guard_standard_descriptors() noexcept {
    for (const int descriptor : {0, 1, 2}) {
        if (::_get_osfhandle(descriptor) < 0) {                                    // -2: there is none
            ::_open("NUL", (descriptor == 1 ? _O_RDONLY : _O_WRONLY) | _O_BINARY); // takes the lowest free number
        }
        ::_setmode(descriptor, _O_BINARY);
    }
}

std::size_t processors() noexcept { return std::max(1U, std::thread::hardware_concurrency()); }

File::File(const char* path, Mode mode) noexcept
    : descriptor_(
          ::_wopen(wide(path).c_str(),
                   (mode == Mode::read ? _O_RDONLY : _O_WRONLY | _O_CREAT | _O_TRUNC) | _O_BINARY | _O_NOINHERIT,
                   _S_IREAD | _S_IWRITE)),
      owned_(true) {}

int File::why_unreadable(const char* path) noexcept {
    if (std::string_view(path) == "-") {
        return 0;
    }
    const DWORD attributes = ::GetFileAttributesW(wide(path).c_str());
    if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
        return EISDIR;
    }
    return File(path, Mode::read).is_open() ? 0 : errno;
}

bool File::is_regular() const noexcept { return type_of(descriptor_) == FILE_TYPE_DISK; }

bool File::is_regular(const char* path) noexcept { return File(path, Mode::read).is_regular(); }

std::string File::name_of_input() { return {}; }

const std::string& File::lines_of_pipe() {
    static const std::string none;
    return none;
}

bool File::shares_bytes(const char* path) const noexcept { return std::string_view(path) == "-" && descriptor_ == 0; }

std::size_t File::size() const noexcept {
    return is_regular() ? static_cast<std::size_t>(::_filelengthi64(descriptor_)) : 0;
}

void File::widen() const noexcept {}

int File::close() noexcept {
    if (!owned_ || descriptor_ < 0) {
        return 0;
    }
    const int result = ::_close(descriptor_);
    descriptor_ = -1;
    return result == 0 ? 0 : errno;
}

std::ptrdiff_t File::read(std::span<char> to) { return ::_read(descriptor_, to.data(), size_of_call(to.size())); }

bool File::is_ready_within(std::chrono::milliseconds time) const {
    const auto end = std::chrono::steady_clock::now() + time;
    const HANDLE handle = handle_of(descriptor_);
    const auto is_ready = [&] {
        DWORD available = 0;
        switch (type_of(descriptor_)) {
        case FILE_TYPE_PIPE: // at its end it fails
            return ::PeekNamedPipe(handle, nullptr, 0, nullptr, &available, nullptr) == 0 || available > 0;
        case FILE_TYPE_CHAR: return ::WaitForSingleObject(handle, 0) == WAIT_OBJECT_0;
        default: return true;
        }
    };
    while (!is_ready()) {
        if (std::chrono::steady_clock::now() >= end) {
            return false;
        }
        ::Sleep(1);
    }
    return true;
}

int File::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const int count = ::_write(descriptor_, bytes.data(), size_of_call(bytes.size()));
        if (count < 0) { // EINVAL is also that of a pipe whose reader has left
            return errno == EINVAL && type_of(descriptor_) == FILE_TYPE_PIPE ? EPIPE : errno;
        }
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

bool OutputFile::is_same(const File& input) const noexcept {
    BY_HANDLE_FILE_INFORMATION mine{};
    BY_HANDLE_FILE_INFORMATION theirs{};
    const auto has_information = [](const File& file, BY_HANDLE_FILE_INFORMATION& information) {
        return file.is_regular() && ::GetFileInformationByHandle(handle_of(file.descriptor()), &information) != 0;
    };
    const File named(file_ ? "" : path_.c_str(), File::Mode::read);
    return has_information(file_ ? *file_ : named, mine) && has_information(input, theirs) &&
           mine.dwVolumeSerialNumber == theirs.dwVolumeSerialNumber && mine.nFileIndexHigh == theirs.nFileIndexHigh &&
           mine.nFileIndexLow == theirs.nFileIndexLow;
}

} // namespace rotconv::stream
