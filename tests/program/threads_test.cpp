// Threads change the speed and nothing else. The inputs are long enough for many blocks.

#include <algorithm>
#include <random>
#include <string>

#include "catch.hpp"
#include "process.hpp"

using namespace program;

namespace {

constexpr const char* thread_counts[] = {"2", "3", "8"};

struct Kinds {
    bool bad = true; ///< rows with errors of every kind
    std::string_view line_end = "\n";
};

/// Rows of a quoted label, four numbers and a field of any length, among comments and blank rows.
std::string made_rows(std::size_t count, const Kinds& kinds) {
    std::mt19937_64 engine(201);
    std::normal_distribution<double> normal;
    const auto number = [&] { return std::to_string(normal(engine)); };
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string label = i % 5 == 0 ? std::string("\"a, \"\"b\"\"\"") : std::to_string(i);
        const std::string good = number() + ',' + number() + ',' + number() + ',' + number();
        const std::string tail = std::string(",").append(1 + engine() % 39, 'y');
        const auto kind = engine() % 40;
        if (kind == 0) {
            text += "# a comment, with a comma";
        } else if (kind == 1) {
            text += " ";
        } else if (kind == 2) {
            text += label + ",0,0,1,0" + tail; // a half-turn
        } else if (kind == 3) {
            text += label + ",1.0000001e150,0,0,0" + tail;
        } else if (kinds.bad && kind == 4) {
            text += label + ",1,zero,0,0" + tail;
        } else if (kinds.bad && kind == 5) {
            text += label + ",0,0,0,0" + tail;
        } else if (kinds.bad && kind == 6) {
            text += label + ",1,1e999";
        } else if (kinds.bad && kind == 7) {
            text += "\"left open," + good + tail;
        } else {
            text += label + ',' + good + tail;
        }
        text += kinds.line_end;
    }
    return text;
}

const std::string to_rotvec = "-f quat -t rotvec --tolerance inf ";

/// The same bytes and the same end for every number of threads, from a file and from a pipe.
void check_threads(const std::string& arguments, const std::string& rows) {
    INFO(arguments);
    const Folder folder;
    const auto file = folder / "rows";
    write_file(file, rows);
    const auto expected = run(arguments + " --threads 1", rows);
    for (const std::string threads : thread_counts) {
        INFO(threads << " threads");
        CHECK((run(arguments + " --threads " + threads, {}, {.input_file = file}) == expected));
    }
    CHECK((run(arguments + " --threads 3", rows) == expected));
    CHECK((run(arguments, {}, {.input_file = file}) == expected));
}

} // namespace

// Catches rows, messages and counts that depend on who was first.
TEST_CASE("every policy and place for diagnostics gives the same bytes with any number of threads") {
    const auto rows = "label,qw,qx,qy,qz,more\n" + made_rows(12'000, {});
    for (const std::string policy : {"nan", "skip"}) {
        for (const std::string place : {"summary", "rows", "columns", "off"}) {
            check_threads(to_rotvec + "--columns qw,qx,qy,qz --on-error " + policy + " --diagnostics " + place, rows);
        }
    }
    check_threads(to_rotvec + "--columns 2-5 --on-error nan --append --strict -p 7", rows);
}

// Catches keys, layouts and line ends that only the first block knows.
TEST_CASE("every format and line end gives the same bytes with any number of threads") {
    for (const std::string_view line_end : {"\n", "\r\n"}) {
        const auto rows = made_rows(10'000, {.line_end = line_end});
        for (const std::string format : {"csv", "json", "pretty"}) {
            check_threads(to_rotvec + "--columns 2-5 --on-error nan --header add --format " + format, rows);
        }
    }
}

// Catches a second header at the end, or none: the first row may come to any of the threads.
TEST_CASE("whoever reads what stands before the first row, the bytes are the same, hundreds of times") {
    const int times = is_sanitized ? 5 : 15;
    const std::string comments = repeated("# c\n", 75'000);
    const std::string blanks = repeated("\n \t\n", 60'000);
    const std::string header = "qw,qx,qy,qz\n";
    for (const std::string mode : {"auto", "yes", "no", "add"}) {
        for (const auto& before : {comments, blanks, comments + blanks, blanks + header + comments}) {
            for (const auto& rows : {std::string("1,0,0,0\n"), repeated("0,1,0,0\n", 30'000), std::string()}) {
                const Folder folder;
                const auto file = folder / "rows";
                write_file(file, before + rows);
                const auto command = "-f quat -t quat:xyzw --on-error nan --diagnostics off --header " + mode;
                const auto expected = run(command + " --threads 1 " + file.string());
                INFO(mode << ", " << rows.size() << " bytes of rows");
                CHECK(count_rows(expected.out) >= count_rows(before + rows));
                int different = 0;
                for (int i = 0; i < times; ++i) {
                    const std::string threads = thread_counts[i % 3];
                    different += run(command + " --threads " + threads + " " + file.string()) == expected ? 0 : 1;
                }
                CHECK(different == 0);
            }
        }
    }
}

// Catches room of the row function that threads share.
TEST_CASE("rates give the same bytes with any number of threads") {
    std::string rows;
    std::mt19937_64 engine(202);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 60'000; ++i) {
        rows += std::to_string(normal(engine)) + (i % 6 == 5 ? '\n' : ' ');
    }
    check_threads("rates -f euler:ZYX --diagnostics rows", rows);
}

// Catches rows that come to them out of order.
TEST_CASE("commands that remember rows give the same bytes with any number of threads") {
    std::string rows;
    for (int i = 0; i < 20'000; ++i) {
        rows += std::to_string(i) + ",0.5," + std::to_string(i % 17) + ",-1\n";
    }
    check_threads("propagate -t quat --interpolation cubic", rows);
    // survey has no --threads: against rows that come slowly, to which one thread is given.
    rows = made_rows(8'000, {});
    const std::string survey = "survey -f quat --on-error skip --tolerance inf --columns 2-5";
    CHECK((run_in_pieces(survey, rows, 10'000) == run(survey, rows)));
}

// Catches blocks after the error that overtake it, blocks before it that are dropped, and a wrong line number.
TEST_CASE("an error stops the stream after the rows before it with any number of threads") {
    const auto good = made_rows(9'000, {.bad = false});
    const auto more = made_rows(30'000, {});
    for (const std::string bad : {"x,1,zero,0,0\n", "x,0,0,0,0\n", "x,1\n"}) {
        const auto rows = good + bad + more;
        check_threads(to_rotvec + "--columns 2-5", rows);
        CHECK(run(to_rotvec + "--columns 2-5 --threads 8", rows) == Failure{2, any_output, {"rotconv: -:9001: "}});
    }
    check_threads(to_rotvec + "--columns 2-5", "x,1,zero,0,0\n" + more);
    check_threads(to_rotvec + "--columns 2-5", good + repeated("z", 5'000'000) + "\n" + more);
}

// Catches the rest of a line that goes to the wrong block.
TEST_CASE("long lines give the same bytes with any number of threads") {
    std::string rows;
    for (std::size_t i = 0; i < 40; ++i) {
        rows += "1 0 0 0 " + repeated("long", i * 2'000) + "\n" + repeated("0 1 0 0 short\n", 200);
    }
    rows += "0 0 1 0 no line end";
    check_threads("-f quat -t quat:xyzw --columns 1-4", rows);
}

// Catches an option that does nothing, and threads that are started for a few rows.
TEST_CASE("large inputs have their threads, small and slow ones have one") {
    Process large(words_of("-f quat -t dcm --threads 3"));
    const auto rows = repeated("0.5 0.5 0.5 0.5\n", 5'000);
    std::size_t most = 0;
    for (int i = 0; i < 200 && most < 3; ++i) {
        large.write(rows);
        most = std::max(most, static_cast<std::size_t>(large.threads()));
    }
    CHECK((most == 3 || (is_sanitized && most == 4))); // ThreadSanitizer has a thread of its own
    CHECK(large.finish().exit_code == 0);

    Process small(words_of("-f quat -t dcm --threads 3"));
    for (int i = 0; i < 20; ++i) {
        small.write(repeated("0.5 0.5 0.5 0.5\n", 50));
        CHECK(count_rows(small.read_rows(50)) == 50);
        CHECK(small.threads() == 1);
    }
    CHECK(small.finish().exit_code == 0);
}

// Catches rows that wait in a thread for more input once there are several.
TEST_CASE("a row after a burst is answered before the next one is sent") {
    Process process(words_of("-f quat -t quat:xyzw --threads 4"));
    for (int burst = 0; burst < 3; ++burst) {
        const auto rows = repeated("1 0 0 0\n", 50'000);
        process.write(rows);
        CHECK(count_rows(process.read_rows(50'000)) == 50'000);
        for (int i = 0; i < 20; ++i) {
            process.write("0 1 0 0\n0 0 1");
            CHECK(process.read_rows(1) == "1 0 0 0\n");
            process.write(" 0\n");
            CHECK(process.read_rows(1) == "0 1 0 0\n");
        }
    }
    CHECK(process.finish() == done(""));
}

// Catches a thread that waits for input and is waited for.
TEST_CASE("an error in a burst ends the run while the input is open") {
    for (const std::string tail : {"", "0 0 1"}) {
        Process process(words_of("-f quat -t quat:xyzw --threads 4"));
        process.write(repeated("1 0 0 0\n", 50'000) + "bad 0 0 0\n" + repeated("1 0 0 0\n", 20'000) + tail);
        const auto result = process.wait();
        CHECK(result.exit_code == 2);
        CHECK(count_rows(result.out) == 50'000);
        CHECK(missing(result.err, {"rotconv: -:50001: "}) == "");
    }
}

// Catches threads that wait for ever, a signal and a message.
TEST_CASE("a reader that leaves ends the threads quietly, with the input open") {
    Process process(words_of("-f quat -t rotvec --threads 4"));
    process.write(repeated("0 1 0 0\n", 30'000));
    process.read_rows(10'000);
    process.close_output();
    process.write(repeated("0 1 0 0\n", 300'000));
    const auto result = process.wait();
    CHECK(result.exit_code == 0);
    CHECK(result.err == "");
}

// Catches interrupted and partial writes and reads that are taken for whole ones.
TEST_CASE("interrupted threads lose nothing") {
    const auto rows = made_rows(20'000, {.bad = false});
    const auto expected = run(to_rotvec + "--columns 2-5 --threads 1", rows);
    Process process(words_of(to_rotvec + "--columns 2-5 --threads 4"));
    for (std::string_view rest = rows; !rest.empty(); rest.remove_prefix(std::min<std::size_t>(rest.size(), 10'000))) {
        process.write(rest.substr(0, 10'000));
        process.interrupt();
    }
    CHECK((process.finish() == expected));
}

// Catches blocks that pile up where the reader is slow, short rows that become long ones in each of many blocks, and
// diagnostics that are kept.
TEST_CASE("memory does not grow with the stream, and little with the threads") {
    const std::size_t rows = 200'000;
    const std::string options = GENERATE(
        as<std::string>{}, "rotvec --threads 1", "dcm --diagnostics columns --format json --threads 2",
        "dcm --diagnostics columns --format json --threads 16", "rpy --diagnostics off --continuous --threads 2");
    const Folder folder;
    const auto file = folder / "rows";
    write_file(file, repeated("1 2 3 4\n4 3 2 1\n", rows));
    Process process(words_of("-f quat --tolerance inf -t " + options), {.input_file = file});
    CHECK(count_rows(process.read_rows(rows / 3)) == rows / 3);
    const long before = process.peak_memory_kib();
    CHECK(count_rows(process.read_rows(rows)) == rows);
    CHECK((is_sanitized || process.peak_memory_kib() - before < 4096));
    CHECK((is_sanitized || process.peak_memory_kib() < 24576));
    CHECK(process.finish().exit_code == 0);
}

// Catches the name of an exception, and a run that seems to have gone well.
TEST_CASE("memory that runs out is called so") {
    if (!is_sanitized) {
        CHECK(run("-f quat -t rpy --threads 1", std::string(4'000'000, '1'), {.memory = 14U << 20U}) ==
              stopped("", {"out of memory"}));
    }
}
