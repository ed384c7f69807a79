#include "process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace program {
namespace {

constexpr auto time_limit = std::chrono::seconds(120); // a hang: no test waits for time to pass

void check(int error, const char* what) {
    if (error != 0) {
        throw std::system_error(error, std::generic_category(), what);
    }
}

/// Its reading and its writing end, neither inherited by children.
std::pair<int, int> make_pipe() {
    std::array<int, 2> ends{};
    check(::pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe");
    return {ends[0], ends[1]};
}

void close_end(int& descriptor) noexcept {
    if (descriptor >= 0) {
        ::close(descriptor);
        descriptor = -1;
    }
}

void set_nonblocking(int descriptor) {
    check(::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK) == 0 ? 0 : errno, "fcntl");
}

/// The environment of this process, less the variables that `changes` sets, and those.
Words changed_environment(const Words& changes) {
    Words environment = changes;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view old = *variable;
        const auto same_name = [old](const std::string& change) {
            return old.starts_with(std::string_view(change).substr(0, change.find('=') + 1));
        };
        if (std::ranges::none_of(changes, same_name)) {
            environment.emplace_back(old);
        }
    }
    return environment;
}

std::vector<char*> pointers_to(Words& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

/// Takes in what is there, and closes the end that has nothing more to come.
void take_in(int& descriptor, std::string& to) {
    std::array<char, 65536> bytes{};
    const auto count = ::read(descriptor, bytes.data(), bytes.size());
    if (count > 0) {
        to.append(bytes.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
        close_end(descriptor);
    }
}

/// What this thread starts from now on cannot close its stdout: the call fails with that errno.
void let_close_fail(int error) {
    constexpr auto number = static_cast<std::uint32_t>(offsetof(seccomp_data, nr));
    constexpr auto descriptor = static_cast<std::uint32_t>(offsetof(seccomp_data, args)); // its low half
    const auto fails = SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error);
    std::array<sock_filter, 6> filter{
        {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_close, 0, 3),
         BPF_STMT(BPF_LD | BPF_W | BPF_ABS, descriptor), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, STDOUT_FILENO, 0, 1),
         BPF_STMT(BPF_RET | BPF_K, fails), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    check(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 ? 0 : errno, "prctl");
    check(::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0 ? 0 : errno, "seccomp");
}

} // namespace

std::ostream& operator<<(std::ostream& to, const Result& result) {
    return to << "exit " << result.exit_code << "\nstdout: " << result.out << "\nstderr: " << result.err;
}

Result done(std::string_view out) { return {0, std::string(out), {}}; }

Failure stopped(std::optional<std::string> out, Words words) { return {2, std::move(out), std::move(words), 1}; }

Failure went_on(std::optional<std::string> out, Words words) { return {1, std::move(out), std::move(words)}; }

bool operator==(const Result& result, const Failure& failure) {
    const auto has = [&](const std::string& word) { return result.err.find(word) != std::string::npos; };
    std::size_t lines = count_rows(result.err);
    for (auto at = result.err.find("\ntry: "); at != std::string::npos; at = result.err.find("\ntry: ", at + 1)) {
        --lines; // of an answer
    }
    return result.exit_code == failure.exit_code && result.out == failure.out.value_or(result.out) &&
           result.err.starts_with("rotconv: ") && failure.lines.value_or(lines) == lines &&
           std::ranges::all_of(failure.words, has);
}

std::ostream& operator<<(std::ostream& to, const Failure& failure) {
    to << "exit " << failure.exit_code << "\nstdout: " << failure.out.value_or("any") << "\nstderr ";
    to << (failure.lines.has_value() ? "in " + std::to_string(*failure.lines) + " lines" : "") << "with:";
    for (const std::string& word : failure.words) {
        to << " '" << word << "'";
    }
    return to;
}

Process::Process(const Words& arguments, const Surroundings& surroundings)
    : limit_(std::chrono::steady_clock::now() + time_limit) {
    std::signal(SIGPIPE, SIG_IGN); // for writes to a program that has ended

    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    int child_input = -1;
    int child_output = -1;
    int child_errors = -1;
    if (surroundings.input_file.empty()) {
        std::tie(child_input, input_) = make_pipe();
        ::posix_spawn_file_actions_adddup2(&files, child_input, STDIN_FILENO);
    } else {
        ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, surroundings.input_file.c_str(), O_RDONLY, 0);
    }
    const auto redirect = [&files](const std::filesystem::path& file, int target, int& ours, int& theirs) {
        if (file.empty()) {
            std::tie(ours, theirs) = make_pipe();
            ::posix_spawn_file_actions_adddup2(&files, theirs, target);
        } else {
            ::posix_spawn_file_actions_addopen(&files, target, file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
        }
    };
    redirect(surroundings.output_file, STDOUT_FILENO, output_, child_output);
    redirect(surroundings.errors_file, STDERR_FILENO, errors_, child_errors);
    for (const int descriptor : {input_, output_, errors_}) {
        if (descriptor >= 0) {
            set_nonblocking(descriptor);
        }
    }

    // The program has to deal with SIGPIPE itself.
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

    Words command{ROTCONV_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    Words environment = changed_environment(surroundings.environment);
    int error = 0;
    const auto spawn = [&] {
        error = ::posix_spawn(&id_, command[0].c_str(), &files, &attributes, pointers_to(command).data(),
                              pointers_to(environment).data());
    };
    if (surroundings.close_error == 0) {
        spawn();
    } else {
        std::thread([&] { // whose filter ends with it
            let_close_fail(surroundings.close_error);
            spawn();
        })
            .join();
    }
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    close_end(child_input);
    close_end(child_output);
    close_end(child_errors);
    if (error != 0) {
        id_ = -1;
        close_end(input_);
        close_end(output_);
        close_end(errors_);
        check(error, "posix_spawn");
    }
    if (surroundings.memory != 0) {
        const rlimit limit{surroundings.memory, surroundings.memory};
        check(::prlimit(id_, RLIMIT_AS, &limit, nullptr) == 0 ? 0 : errno, "prlimit");
    }
}

Process::~Process() {
    if (id_ > 0) {
        ::kill(id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
    close_end(input_);
    close_end(output_);
    close_end(errors_);
}

void Process::step(std::string_view& to_write, std::chrono::milliseconds at_most) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(limit_ - std::chrono::steady_clock::now());
    if (left.count() <= 0) {
        throw std::runtime_error("the program took too long; stdout so far: " + out_.substr(0, 1000) +
                                 "\nstderr: " + err_.substr(0, 1000));
    }
    // poll() skips descriptors below 0.
    std::array<pollfd, 3> ends{
        {{to_write.empty() ? -1 : input_, POLLOUT, 0}, {output_, POLLIN, 0}, {errors_, POLLIN, 0}}};
    ::poll(ends.data(), ends.size(), static_cast<int>(std::min(left, at_most).count()));
    if (ends[0].revents != 0) {
        const auto count = ::write(input_, to_write.data(), to_write.size());
        if (count >= 0) {
            to_write.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EAGAIN && errno != EINTR) {
            close_end(input_);
        }
    }
    if (ends[1].revents != 0) {
        take_in(output_, out_);
    }
    if (ends[2].revents != 0) {
        take_in(errors_, err_);
    }
}

void Process::write(std::string_view bytes) {
    while (!bytes.empty() && input_ >= 0) {
        step(bytes, time_limit);
    }
}

void Process::wait_until_read() {
    std::string_view nothing;
    while (output_ >= 0 || errors_ >= 0) { // it lives
        int unread = 0;
        if (::ioctl(input_, FIONREAD, &unread) != 0 || unread == 0) {
            return;
        }
        step(nothing, std::chrono::milliseconds(1));
    }
}

long Process::peak_memory_after(std::string_view bytes) {
    write(bytes);
    wait_until_read();
    return peak_memory_kib();
}

std::string Process::read_rows(std::size_t count) {
    std::string_view nothing;
    std::size_t found = 0;
    std::size_t end = 0;
    while (true) {
        while (found < count) {
            const auto newline = out_.find('\n', end);
            if (newline == std::string::npos) {
                break;
            }
            end = newline + 1;
            ++found;
        }
        if (found == count || output_ < 0) {
            std::string rows = out_.substr(0, end);
            out_.erase(0, end);
            return rows;
        }
        step(nothing, time_limit);
    }
}

void Process::close_output() noexcept { close_end(output_); }

void Process::close_input() noexcept { close_end(input_); }

Result Process::wait() {
    std::string_view nothing;
    while (output_ >= 0 || errors_ >= 0) {
        step(nothing, time_limit);
    }
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), std::move(out_), std::move(err_)};
}

Result Process::finish() {
    close_input();
    return wait();
}

void Process::interrupt() const {
    ::kill(id_, SIGSTOP);
    ::kill(id_, SIGCONT);
}

long Process::peak_memory_kib() const { return status("VmHWM:"); }

long Process::threads() const { return status("Threads:"); }

long Process::status(std::string_view name) const {
    std::ifstream status("/proc/" + std::to_string(id_) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name)) {
            return std::stol(line.substr(name.size()));
        }
    }
    throw std::runtime_error("/proc does not tell of the program: " + std::string(name));
}

Result run(const Words& arguments, std::string_view input, const Surroundings& surroundings) {
    Process process(arguments, surroundings);
    process.write(input);
    return process.finish();
}

Result run(std::string_view arguments, std::string_view input, const Surroundings& surroundings) {
    return run(words_of(arguments), input, surroundings);
}

Result run_in_pieces(std::string_view arguments, std::string_view input, std::size_t size) {
    Process process(words_of(arguments));
    for (std::size_t at = 0; at < input.size(); at += size) {
        process.write(input.substr(at, size));
        process.wait_until_read();
    }
    return process.finish();
}

Words words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    return {std::istream_iterator<std::string>(stream), {}};
}

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "rotconv-XXXXXX").string();
    check(::mkdtemp(name.data()) != nullptr ? 0 : errno, "mkdtemp");
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

Files& Files::add(const std::string& name, std::string_view text) {
    write_file(folder_ / name, text);
    return *this;
}

Result Files::operator()(const std::string& arguments, const std::string& input) const {
    Words words = words_of(arguments);
    for (std::string& word : words) {
        word = word.starts_with('@') ? path(word.substr(1)) : word;
    }
    Result result = run(words, input);
    const std::string folder = path("");
    for (auto at = result.err.find(folder); at != std::string::npos; at = result.err.find(folder)) {
        result.err.erase(at, folder.size());
    }
    return result;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) {
        throw std::runtime_error("cannot write " + path.string());
    }
}

std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot read " + path.string());
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t count_rows(std::string_view text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

Words fields_of(std::string_view row, char delimiter) {
    if (row.ends_with('\n')) {
        row.remove_suffix(1);
    }
    Words fields;
    while (true) {
        const auto end = row.find(delimiter);
        fields.emplace_back(row.substr(0, end));
        if (end == std::string_view::npos) {
            return fields;
        }
        row.remove_prefix(end + 1);
    }
}

std::string repeated(std::string_view text, std::size_t times) {
    std::string result;
    result.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) {
        result += text;
    }
    return result;
}

std::string last_line(const std::string& text) {
    const auto end = text.rfind('\n');
    const auto begin = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    return text.substr(begin + 1, end - begin - 1);
}

std::string bytes_of(const std::vector<double>& numbers) {
    const auto* const bytes = reinterpret_cast<const char*>(numbers.data());
    return {bytes, bytes + numbers.size() * sizeof(double)};
}

std::string missing(std::string_view text, std::initializer_list<std::string_view> words) {
    std::string result;
    for (const std::string_view word : words) {
        if (text.find(word) == std::string_view::npos) {
            result += "no '" + std::string(word) + "'; ";
        }
    }
    return result.empty() ? result : result + "in: " + std::string(text.substr(0, 2000));
}

} // namespace program
