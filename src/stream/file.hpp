#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rotconv::stream {

/// The processors that this process may use, at least 1.
[[nodiscard]] std::size_t processors() noexcept;

/// Where bytes come from.
class Source {
public:
    Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    virtual ~Source() = default;

    /// Reads at least one byte into `to` and as many as are there; 0 at the end, -1 with errno set.
    virtual std::ptrdiff_t read(std::span<char> to) = 0;
    /// Whether read() would return at once.
    [[nodiscard]] virtual bool is_ready() const { return true; }
};

/// Where bytes go.
class Sink {
public:
    Sink() = default;
    Sink(const Sink&) = delete;
    Sink& operator=(const Sink&) = delete;
    virtual ~Sink() = default;

    /// Writes all of it; 0, or the errno of what went wrong.
    virtual int write(std::string_view bytes) = 0;
};

/// Makes sure that no file that is opened later takes the place of a standard descriptor that the caller has closed:
/// such a descriptor is given something that fails to be read (0) or written (1), or swallows all (2).
void guard_standard_descriptors() noexcept;

/// A text in memory, read once.
class TextSource final : public Source {
public:
    explicit TextSource(std::string_view text) noexcept : text_(text) {}
    std::ptrdiff_t read(std::span<char> to) override;

private:
    std::string_view text_;
};

/// An open file descriptor, closed at the end where it is owned. Interrupted calls are taken up again.
class File final : public Source, public Sink {
public:
    enum class Mode { read, write };
    /// Opens the file, which is emptied where it is to be written; test with is_open(), errno says why not.
    File(const char* path, Mode mode) noexcept;
    /// Borrows a descriptor, or takes it over.
    explicit File(int descriptor, bool owned = false) noexcept : descriptor_(descriptor), owned_(owned) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() override;

    [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    /// An errno where no file of that name can be read; 0 where one can, and for "-".
    [[nodiscard]] static int why_unreadable(const char* path) noexcept;
    [[nodiscard]] bool is_regular() const noexcept;
    /// A file of that name, or "-", would miss what is read from this one: a pipe, socket or terminal, or both stdin.
    [[nodiscard]] bool shares_bytes(const char* path) const noexcept;
    /// Bytes of a regular file; 0 for anything else.
    [[nodiscard]] std::size_t size() const noexcept;
    /// Lets a pipe hold more, where the system allows it: the two ends then seldom wait for each other.
    void widen() const noexcept;
    /// Closes the file, which is where some file systems first report a full disk; 0 or an errno.
    int close() noexcept;

    std::ptrdiff_t read(std::span<char> to) override;
    [[nodiscard]] bool is_ready() const override;
    int write(std::string_view bytes) override;

private:
    int descriptor_;
    bool owned_ = false;
};

/// Where a run's output goes: a file that is opened, and its old content lost, when the first bytes come, or stdout.
class OutputFile final : public Sink {
public:
    /// "-": stdout.
    explicit OutputFile(std::string path);

    /// The same regular file is behind both.
    [[nodiscard]] bool is_same(const File& input) const noexcept;
    int write(std::string_view bytes) override;
    /// To be called at the end of a run, and creates the file if the run `is_whole` and wrote nothing. Closes it, see
    /// File::close().
    int finish(bool is_whole);

private:
    int open();

    std::string path_;
    std::optional<File> file_; ///< once it is open
};

} // namespace rotconv::stream
