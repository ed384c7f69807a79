// bench_stream: the program against its floors, as processes, in one table of ratios: bare loops that read, convert in
// plain double and print, a copy of the bytes, and the start of mawk. bench_tools has other tools.
//
// Each pair is run in turns; the least of each side counts. One process with one thread is measured in processor time,
// several by the clock. Two processes with half of the rows each show what the machine had for two threads at the time.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "processes.hpp"

namespace {

constexpr int rows = 1'000'000;

enum class Measure { clock, processor };

/// What is compared: how many times as fast is the first command as the second?
struct Comparison {
    std::string what;
    std::string command;
    std::string reference;
    Measure measure;
    int rounds = 7;
};

void compare(const Comparison& comparison) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Time ours{infinity, infinity};
    Time reference = ours;
    for (int i = 0; i < comparison.rounds; ++i) {
        ours = least(ours, time_of(comparison.command));
        reference = least(reference, time_of(comparison.reference));
    }
    const bool by_clock = comparison.measure == Measure::clock;
    const auto seconds = [by_clock](const Time& time) { return by_clock ? time.clock : time.processor; };
    fmt::print("| {} | {:.3f} s | {:.3f} s | {} | {:.2f} |\n", comparison.what, seconds(ours), seconds(reference),
               by_clock ? "clock" : "processor", seconds(reference) / seconds(ours));
    std::fflush(stdout);
}

/// The same attitudes as rows, four times, in two halves, with a header and more columns, with a column between their
/// numbers, and as doubles.
void write_inputs(const Folder& folder) {
    Attitudes attitudes;
    std::ofstream plain(folder / "quat");
    std::ofstream columns(folder / "columns");
    std::ofstream apart(folder / "apart");
    std::ofstream first(folder / "first");
    std::ofstream second(folder / "second");
    columns << "time,qw,qx,qy,qz,label\n";
    for (int i = 0; i < rows; ++i) {
        const std::string row = attitudes.next_row();
        plain << row << '\n';
        (i < rows / 2 ? first : second) << row << '\n';
        columns << i << ',' << row << ",imu\n";
        const std::size_t second_comma = row.find(',', row.find(',') + 1);
        apart << row.substr(0, second_comma) << ",imu" << row.substr(second_comma) << '\n';
    }
    plain.close();
    apart.close();
    for (int i = 0; i < 4; ++i) {
        std::ofstream(folder / "four", std::ios::app) << std::ifstream(folder / "quat").rdbuf();
    }
    Attitudes again;
    std::ofstream doubles(folder / "doubles", std::ios::binary);
    for (int i = 0; i < rows; ++i) {
        const auto q = again.next();
        doubles.write(reinterpret_cast<const char*>(&q), sizeof q);
    }
}

std::string rotconv(const std::string& to, int threads, const std::string& from = "quat") {
    return fmt::format("exec {} -f {} -t {} --diagnostics off --threads {}", ROTCONV_PROGRAM, from, to, threads);
}

/// Against loops that compute in plain double, of the same libraries alone and with the program's digits.
void compare_loops(const Folder& folder) {
    struct Loop {
        std::string from, to, name;
    };
    for (const auto& [from, to, name] : {Loop{"quat", "dcm", "dcm"}, Loop{"dcm", "rpy:deg", "rpy"},
                                         Loop{"rpy:deg", "quat", "quat"}, Loop{"quat", "rotvec", "rotvec"}}) {
        const std::string input = " < " + folder / from.c_str();
        const std::string away = " > /dev/null";
        if (from != "quat") {
            static_cast<void>(time_of(rotconv(from, 2) + " < " + folder / "quat" + " > " + folder / from.c_str()));
        }
        for (const std::string digits : {"", " libraries"}) {
            compare({fmt::format("{} to {}, against a bare loop {}", from, to,
                                 digits.empty() ? "with the same digits" : "of the libraries alone"),
                     rotconv(to, 1, from) + input + away, "exec " BARE_LOOP " " + name + digits + input + away,
                     Measure::processor, 9});
        }
        const std::string few = folder / (from + "4").c_str(); // as files of people have them
        static_cast<void>(time_of(rotconv(from, 2, from) + " --decimals 4 --tolerance inf" + input + " > " + few));
        compare({fmt::format("{} of four decimals to {}, against a bare loop of the libraries alone", from, to),
                 rotconv(to, 1, from) + " < " + few + away, "exec " BARE_LOOP " " + name + " libraries < " + few + away,
                 Measure::processor, 9});
    }
}

void compare_floors(const Folder& folder) {
    const std::string plain = " < " + folder / "quat" + " > /dev/null";
    const std::string columns = " < " + folder / "columns" + " > /dev/null";
    const std::string four = " < " + folder / "four" + " > /dev/null";
    const auto half = [&](const char* name) {
        return "(" + rotconv("dcm", 1) + " < " + folder / name + " > /dev/null) & ";
    };
    compare({"with header and extra columns, against plain rows",
             rotconv("dcm", 1) + " --columns qw,qx,qy,qz" + columns, rotconv("dcm", 1) + plain, Measure::processor});
    compare({"with a column between two numbers, against plain rows",
             rotconv("dcm", 1) + " --columns 1,2,4,5 < " + folder / "apart" + " > /dev/null", rotconv("dcm", 1) + plain,
             Measure::processor});
    compare({"two threads, against one, 4 million rows", rotconv("dcm", 2) + four, rotconv("dcm", 1) + four,
             Measure::clock, 5});
    compare({"two threads, against two processes with half of the rows each", rotconv("dcm", 2) + plain,
             half("first") + half("second") + "wait", Measure::clock});
    const std::string pipe = "cat " + folder / "doubles" + " | ";
    compare({"rows of doubles, pipe to pipe, against `cat`",
             pipe + "(" + rotconv("quat:xyzw", 2) + " --input-format f64 --format f64) | cat > /dev/null",
             pipe + "cat | cat > /dev/null", Measure::clock, 21});
}

void compare_starts() {
    if (std::system("mawk 'BEGIN{}' > /dev/null 2>&1") != 0) {
        fmt::print("| 200 starts, against mawk | | not installed | | |\n");
        return;
    }
    const auto repeated = [](const std::string& command) {
        return "i=0; while [ $i -lt 200 ]; do " + command + " > /dev/null; i=$((i+1)); done";
    };
    compare({"200 starts for one attitude, against `mawk 'BEGIN{}'`",
             repeated(ROTCONV_PROGRAM " -f quat -t dcm 1 0 0 0"), repeated("mawk 'BEGIN{}'"), Measure::processor});
}

} // namespace

int main() {
    try {
        const Folder folder;
        write_inputs(folder);
        fmt::print("{} rows of 17 digits, the least of several runs in turns\n\n", rows);
        fmt::print("| what | rotconv | reference | measure | times as fast |\n| --- | --- | --- | --- | --- |\n");
        compare_loops(folder);
        compare_floors(folder);
        compare_starts();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_stream: %s\n", error.what());
        return 1;
    }
    return 0;
}
