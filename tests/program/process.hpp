#pragma once

#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

/// Runs the program as a user does: a real process with real pipes.
namespace program {

using Words = std::vector<std::string>;

/// How the program ended and what it said.
struct Result {
    int exit_code = -1; ///< minus the number of the signal that killed it
    std::string out;
    std::string err;

    bool operator==(const Result&) const = default;
};

std::ostream& operator<<(std::ostream& to, const Result& result);

/// Exit 0, this output, and not a word on stderr.
Result done(std::string_view out);

/// What a run comes to that does not go well.
struct Failure {
    int exit_code;
    std::optional<std::string> out;        ///< none: any
    Words words = {};                      ///< that stderr has
    std::optional<std::size_t> lines = {}; ///< of stderr, but for answers; none: any number
};

inline constexpr std::nullopt_t any_output = std::nullopt;

/// Exit 2, this output, and one line on stderr, with these words.
Failure stopped(std::optional<std::string> out, Words words = {});
/// Exit 1, this output, and lines on stderr with these words.
Failure went_on(std::optional<std::string> out, Words words = {});

bool operator==(const Result& result, const Failure& failure);
std::ostream& operator<<(std::ostream& to, const Failure& failure);

struct Surroundings {
    Words environment = {};                 ///< such as LC_ALL=C, over what the tests were started with
    std::filesystem::path input_file = {};  ///< stdin; empty: a pipe
    std::filesystem::path output_file = {}; ///< stdout; empty: a pipe
    std::filesystem::path errors_file = {}; ///< stderr; empty: a pipe
    int close_error = 0;                    ///< an errno with which closing stdout fails
    unsigned long memory = 0;               ///< a limit in bytes, from the start of its reading; 0: none
};

/// A started program. Every wait has a time limit, after which the program is killed and the test fails.
class Process {
public:
    explicit Process(const Words& arguments, const Surroundings& surroundings = {});
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process();

    /// Writes all of it to stdin, while output is taken in; what a program that has ended does not read is dropped.
    void write(std::string_view bytes);
    /// Waits until the program has read all that was written.
    void wait_until_read();
    /// Writes all of it, and tells the largest amount of memory that the program has held once it has read that.
    long peak_memory_after(std::string_view bytes);
    /// The next `count` rows of stdout, as soon as they are there; fewer where the output ends.
    std::string read_rows(std::size_t count);
    /// The reader of stdout leaves.
    void close_output() noexcept;
    void close_input() noexcept;
    /// Waits for the end, without closing stdin. `out` is what has not been read before.
    Result wait();
    /// Closes stdin and waits for the end.
    Result finish();

    /// The largest amount of memory that it has held so far.
    [[nodiscard]] long peak_memory_kib() const;
    /// The threads that it has now.
    [[nodiscard]] long threads() const;
    /// Stops it and lets it go on, which interrupts calls of the system.
    void interrupt() const;

private:
    /// Waits for something to happen on the pipes, at most until the time limit, and takes in what came.
    void step(std::string_view& to_write, std::chrono::milliseconds at_most);
    /// A number of /proc/ID/status.
    [[nodiscard]] long status(std::string_view name) const;

    pid_t id_ = -1;
    int input_ = -1;
    int output_ = -1;
    int errors_ = -1;
    std::string out_;
    std::string err_;
    std::chrono::steady_clock::time_point limit_;
};

/// A conversion that keeps every number, and has work to do.
inline const std::string reorder = "-f quat -t quat:xyzw ";

/// Runs the program to its end.
Result run(const Words& arguments, std::string_view input = {}, const Surroundings& surroundings = {});
/// The same, with the arguments in one text, parted by blanks.
Result run(std::string_view arguments, std::string_view input = {}, const Surroundings& surroundings = {});

/// The same, with an input that comes `size` bytes at a time.
Result run_in_pieces(std::string_view arguments, std::string_view input, std::size_t size);

Words words_of(std::string_view text);

/// A new folder, removed at the end with all that is in it.
class Folder {
public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    [[nodiscard]] std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

/// Files of a folder and the program, run on them.
class Files {
public:
    Files& add(const std::string& name, std::string_view text);
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    /// @param arguments names of files stand as @NAME; messages have their names alone
    [[nodiscard]] Result operator()(const std::string& arguments, const std::string& input = {}) const;

private:
    Folder folder_;
};

void write_file(const std::filesystem::path& path, std::string_view bytes);
std::string read_file(const std::filesystem::path& path);

std::size_t count_rows(std::string_view text);
/// The fields of a row parted by one character.
Words fields_of(std::string_view row, char delimiter);
std::string repeated(std::string_view text, std::size_t times);
std::string last_line(const std::string& text);
/// Doubles as they are in memory.
std::string bytes_of(const std::vector<double>& numbers);

/// The words that a text should have and has not, with the text; empty where it has them all.
std::string missing(std::string_view text, std::initializer_list<std::string_view> words);

} // namespace program
