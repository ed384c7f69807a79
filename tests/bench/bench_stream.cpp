// bench_stream [ROWS]: the program against its floors, as processes, in one table of ratios: bare loops that only parse
// and print with the same libraries, a copy of the bytes, the start of mawk, and other tools where they are installed.
//
// Each pair is run in turns; the least of each side counts. One process with one thread is measured in processor time,
// several by the clock. Two processes with half of the rows each show what the machine had for two threads at the time.

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stream/number_text.hpp"

namespace {

constexpr int rounds = 7;
const std::string program = ROTCONV_PROGRAM;

// The bare loops, which run in a process of their own: stdin to stdout.

void print(fmt::memory_buffer& out, const double* numbers, std::size_t count) {
    rotconv::stream::append_numbers(out, {numbers, count}, ',');
    out.push_back('\n');
}

void to_dcm(fmt::memory_buffer& out, const double* q) {
    const double w = q[0];
    const double x = q[1];
    const double y = q[2];
    const double z = q[3];
    const double m[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                         2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                         2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    print(out, m, 9);
}

void to_euler(fmt::memory_buffer& out, const double* q) {
    const double w = q[0];
    const double x = q[1];
    const double y = q[2];
    const double z = q[3];
    const double angles[3] = {std::atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z),
                              std::asin(std::clamp(2 * (w * y - x * z), -1.0, 1.0)),
                              std::atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z)};
    print(out, angles, 3);
}

/// No check, no field that passes, no line counted; the rows end with a line end.
template <class Convert> int run_bare_loop(const Convert& convert) {
    std::vector<char> block(std::size_t{64} << 10U);
    fmt::memory_buffer out;
    std::size_t held = 0;
    while (true) {
        const auto count = ::read(STDIN_FILENO, block.data() + held, block.size() - held);
        if (count <= 0) {
            return 0;
        }
        const std::size_t filled = held + static_cast<std::size_t>(count);
        const std::size_t end = std::string_view(block.data(), filled).rfind('\n') + 1;
        const char* at = block.data();
        while (at < block.data() + end) {
            double q[4];
            for (double& component : q) {
                at = std::from_chars(at, block.data() + end, component).ptr + 1;
            }
            convert(out, q);
        }
        held = filled - end;
        std::memmove(block.data(), block.data() + end, held);
        if (::write(STDOUT_FILENO, out.data(), out.size()) < 0) {
            return 1;
        }
        out.clear();
    }
}

struct Time {
    double clock = std::numeric_limits<double>::infinity(); ///< seconds
    double processor = clock;                               ///< likewise, of the user and the system
};

Time least(const Time& a, const Time& b) { return {std::min(a.clock, b.clock), std::min(a.processor, b.processor)}; }

Time time_of(const std::string& command) {
    const auto start = std::chrono::steady_clock::now();
    const pid_t id = ::fork();
    if (id == 0) {
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        std::_Exit(127);
    }
    int status = 0;
    rusage used{};
    ::wait4(id, &status, 0, &used);
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
    if (status != 0) {
        throw std::runtime_error("this failed: " + command);
    }
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return {clock.count(), seconds(used.ru_utime) + seconds(used.ru_stime)};
}

bool is_installed(const std::string& test) { return std::system((test + " > /dev/null 2>&1").c_str()) == 0; }

enum class Measure { clock, processor };

/// What is compared: how many times as fast is the first command as the second?
struct Comparison {
    std::string what;
    std::string command;
    std::string reference;
    Measure measure;
    std::string goal;
};

void compare(const Comparison& comparison) {
    Time ours;
    Time reference;
    for (int i = 0; i < rounds; ++i) {
        ours = least(ours, time_of(comparison.command));
        reference = least(reference, time_of(comparison.reference));
    }
    const auto seconds = [&comparison](const Time& time) {
        return comparison.measure == Measure::clock ? time.clock : time.processor;
    };
    fmt::print("| {} | {:.3f} | {:.3f} | {} | {:.2f} | {} |\n", comparison.what, seconds(ours), seconds(reference),
               comparison.measure == Measure::clock ? "clock" : "processor", seconds(reference) / seconds(ours),
               comparison.goal);
    std::fflush(stdout);
}

/// The same attitudes as rows, as rows with a header and more columns, and as doubles.
void write_inputs(const std::filesystem::path& folder, int rows) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    std::ofstream plain(folder / "plain");
    std::ofstream columns(folder / "columns");
    std::ofstream first(folder / "first");
    std::ofstream second(folder / "second");
    std::ofstream doubles(folder / "doubles", std::ios::binary);
    columns << "time,qw,qx,qy,qz,label\n";
    for (int i = 0; i < rows; ++i) {
        double q[4] = {normal(engine), normal(engine), normal(engine), normal(engine)};
        const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        std::ranges::for_each(q, [norm](double& component) { component /= norm; });
        const auto row = fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}", q[0], q[1], q[2], q[3]);
        plain << row << '\n';
        (i < rows / 2 ? first : second) << row << '\n';
        columns << i << ',' << row << ",imu\n";
        doubles.write(reinterpret_cast<const char*>(q), sizeof q);
    }
}

void print_table(const std::filesystem::path& folder, int rows) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const auto file = [&folder](const char* name) { return (folder / name).string(); };
    const std::string plain = " < " + file("plain") + " > /dev/null";
    const std::string columns = " < " + file("columns") + " > /dev/null";
    const auto rotconv = [](const std::string& to, int threads) {
        return fmt::format("exec {} -f quat -t {} --diagnostics off --threads {}", program, to, threads);
    };
    const auto repeated = [](const std::string& command) {
        return "i=0; while [ $i -lt 200 ]; do " + command + " > /dev/null; i=$((i+1)); done";
    };
    fmt::print("{} rows, the least of {} runs in turns, seconds\n\n", rows, rounds);
    fmt::print(
        "| what | rotconv | reference | measure | times as fast | goal |\n| --- | --- | --- | --- | --- | --- |\n");
    compare({"one thread, quat to dcm, against the bare loop", rotconv("dcm", 1) + plain,
             "exec " + self + " bare dcm" + plain, Measure::processor, "0.85"});
    compare({"two threads against one", rotconv("dcm", 2) + plain, rotconv("dcm", 1) + plain, Measure::clock, "1.8"});
    const auto half = [&](const char* name) {
        return "(" + rotconv("dcm", 1) + " < " + file(name) + " > /dev/null) & ";
    };
    compare({"two threads against two processes", rotconv("dcm", 2) + plain, half("first") + half("second") + "wait",
             Measure::clock, "1"});
    compare({"header and extra columns against plain rows", rotconv("dcm", 1) + " --columns qw,qx,qy,qz" + columns,
             rotconv("dcm", 1) + plain, Measure::processor, "0.85"});
    compare({"quat to euler against the bare loop with libm", rotconv("euler:ZYX", 1) + plain,
             "exec " + self + " bare euler" + plain, Measure::processor, "0.85"});
    const std::string pipe = "cat " + file("doubles") + " | ";
    compare({"doubles, pipe to pipe, against cat",
             pipe + "(" + rotconv("quat:xyzw", 2) + " --input-format f64 --format f64) | cat > /dev/null",
             pipe + "cat | cat > /dev/null", Measure::clock, "0.7"});
    if (is_installed("mawk 'BEGIN{}'")) {
        compare({"200 starts, one attitude each, against mawk 'BEGIN{}'", repeated(program + " -f quat -t dcm 1 0 0 0"),
                 repeated("mawk 'BEGIN{}'"), Measure::processor, "1"});
        const std::string script =
            "BEGIN{FS=OFS=\",\";OFMT=\"%.17g\"}{w=$1;x=$2;y=$3;z=$4;print 1-2*(y*y+z*z),2*(x*y-w*z),2*(x*z+w*y),"
            "2*(x*y+w*z),1-2*(x*x+z*z),2*(y*z-w*x),2*(x*z-w*y),2*(y*z+w*x),1-2*(x*x+y*y)}";
        compare({"two threads against mawk", rotconv("dcm", 2) + plain, "exec mawk '" + script + "'" + plain,
                 Measure::clock, "12"});
    }
    if (is_installed("python3 -c 'import pandas, scipy'")) {
        const std::string script =
            "import pandas, sys; from scipy.spatial.transform import Rotation as R; "
            "q = pandas.read_csv(sys.stdin, header=None).to_numpy()[:, [1, 2, 3, 0]]; "
            "pandas.DataFrame(R.from_quat(q).as_matrix().reshape(-1, 9)).to_csv(sys.stdout, header=False, index=False)";
        compare({"two threads against pandas and SciPy", rotconv("dcm", 2) + plain,
                 "exec python3 -c '" + script + "'" + plain, Measure::clock, "30"});
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "bare") {
        return std::string_view(argv[2]) == "dcm" ? run_bare_loop(to_dcm) : run_bare_loop(to_euler);
    }
    const int rows = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
    std::string name = (std::filesystem::temp_directory_path() / "rotconv-bench-XXXXXX").string();
    if (rows < 1 || ::mkdtemp(name.data()) == nullptr) {
        std::puts("usage: bench_stream [ROWS]");
        return 2;
    }
    int code = 0;
    try {
        write_inputs(name, rows);
        print_table(name, rows);
    } catch (const std::exception& error) {
        std::puts(error.what());
        code = 1;
    }
    std::filesystem::remove_all(name);
    return code;
}
