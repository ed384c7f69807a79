#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace rotconv::stream {

/// The processors that this process may use, at least 1.
[[nodiscard]] std::size_t processors() noexcept;

/// A source of bytes.
class Source {
public:
    Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    virtual ~Source() = default;

    /// Reads as many bytes as are there, at least one. @return their count, 0 at the end, -1 with errno set
    virtual std::ptrdiff_t read(std::span<char> to) = 0;
    /// Whether read() would return at once.
    [[nodiscard]] virtual bool is_ready() const { return true; }
};

/// A destination of bytes.
class Sink {
public:
    Sink() = default;
    Sink(const Sink&) = delete;
    Sink& operator=(const Sink&) = delete;
    virtual ~Sink() = default;

    /// Writes all bytes. @return 0 or an errno
    virtual int write(std::string_view bytes) = 0;
};

/// Makes sure that no file that is opened later takes the place of a standard descriptor that the caller has closed:
/// such a descriptor is given something that fails to be read (0) or written (1), or swallows all (2).
void guard_standard_descriptors() noexcept;

/// A text in memory, read once.
class TextSource final : public Source {
public:
    explicit TextSource(std::string text) noexcept : text_(std::move(text)) {}
    std::ptrdiff_t read(std::span<char> to) override;

private:
    std::string text_;
    std::size_t done_ = 0; ///< bytes
};

/// An open file descriptor, closed at the end if it is owned. Interrupted calls are repeated.
class File final : public Source, public Sink {
public:
    enum class Mode { read, write };
    /// Opens the file, and empties it to be written; test with is_open(), errno says why not.
    File(const char* path, Mode mode) noexcept;
    /// Borrows a descriptor, or takes it over.
    explicit File(int descriptor, bool owned = false) noexcept : descriptor_(descriptor), owned_(owned) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() override;

    [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    /// @return an errno if no file of that name can be read; 0 if one can, and for "-"
    [[nodiscard]] static int why_unreadable(const char* path) noexcept;
    [[nodiscard]] bool is_regular() const noexcept;
    /// Asked before it is opened: to open a pipe is to wait for its writer.
    [[nodiscard]] static bool is_regular(const char* path) noexcept;
    /// The name of the regular file that stdin is, from the folder of the program on, where the system tells it.
    [[nodiscard]] static std::string name_of_input();
    /// The first whole lines that a pipe at stdin has, for which it waits a moment: where nothing will read it. Empty
    /// for another stdin.
    [[nodiscard]] static const std::string& lines_of_pipe();
    /// Whether a file of that name, or "-", would miss bytes read here: a pipe, socket or terminal, or both stdin.
    [[nodiscard]] bool shares_bytes(const char* path) const noexcept;
    /// Bytes of a regular file; 0 for anything else.
    [[nodiscard]] std::size_t size() const noexcept;
    /// Lets a pipe hold more, if the system allows it: the two ends then seldom wait for each other.
    void widen() const noexcept;
    /// Closes the file; some file systems report a full disk only then. @return 0 or an errno
    int close() noexcept;

    std::ptrdiff_t read(std::span<char> to) override;
    [[nodiscard]] bool is_ready() const override;
    /// Whether read() has something, or its end, within that time.
    [[nodiscard]] bool is_ready_within(std::chrono::milliseconds time) const;
    int write(std::string_view bytes) override;

private:
    int descriptor_;
    bool owned_ = false;
};

/// The output of a run: stdout, or a file that is opened, and its old content lost, when the first bytes come.
class OutputFile final : public Sink {
public:
    /// "-": stdout.
    explicit OutputFile(std::string path);

    /// Whether both are the same regular file.
    [[nodiscard]] bool is_same(const File& input) const noexcept;
    int write(std::string_view bytes) override;
    /// To be called at the end of a run: creates the file if the run `is_whole` and wrote nothing, and closes it.
    /// @return see File::close()
    int finish(bool is_whole);

private:
    int open();

    std::string path_;
    std::optional<File> file_; ///< once it is open
};

} // namespace rotconv::stream
