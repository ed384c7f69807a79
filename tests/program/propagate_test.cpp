
#include <catch.hpp>

#include "process.hpp"

using namespace program;

// Catches an answer that waits.
TEST_CASE("with linear interpolation a row is answered before the next one is sent") {
    Process process(words_of("propagate -t rotvec -p 6"));
    process.write("0 0 0 1\n");
    CHECK(process.read_rows(1) == "0 0 0 0\n");
    process.write("1 0 0 1\n");
    CHECK(process.read_rows(1) == "1 0 0 1\n");
    CHECK(process.finish() == done(""));
}

// Catches rows, comments and line numbers that get lost on the way.
TEST_CASE("with cubic interpolation a row is answered when the next one is there") {
    Process process(words_of("propagate -t rotvec -p 6 --interpolation cubic --on-error nan"));
    process.write("0 0 0 1\n# one\n");
    process.wait_until_read();
    process.write("1 0 0 1\n");
    CHECK(process.read_rows(2) == "0 0 0 0\n# one\n");
    process.write("\nbad 0 0 1\n");
    process.wait_until_read();
    process.write("2 0 0 1\n");
    CHECK(process.read_rows(3) == "1 0 0 1\n\nbad nan nan nan\n");
    CHECK(process.finish() == went_on("2 0 0 2\n", {"rotconv: -:5: not a number: 'bad'"}));
}

// Catches memory, or time, that grows with a clock that stepped back, or with comments.
TEST_CASE("rows that are refused do not keep the one before them waiting for ever") {
    for (const std::string row : {"0 0 0 1e-3\n", "# nothing\n"}) {
        Process process(words_of("propagate -t quat --interpolation cubic --on-error skip --diagnostics off"));
        const long before = process.peak_memory_after("5 0 0 1e-3\n6 0 0 1e-3\n" + repeated(row, 30000));
        process.write(repeated(row, 60000));
        CHECK((process.peak_memory_after("7 0 0 1e-3\n8 0 0 1e-3\n") <= before + 512 || is_sanitized));
        const auto result = process.finish();
        CHECK(count_rows(result.out) == (row[0] == '#' ? 90004 : 4));
        CHECK(result.out.substr(result.out.find("\n8 ") + 1, 2) == "8 ");
    }
}

// Catches an answer that is given early because of a block's border.
TEST_CASE("cubic answers do not depend on how the rows arrive") {
    const std::string rows = "0 0 0 0.1\n1 0 0 0.2\n" + repeated("0 0 0 9\n", 9000) + // 72 kB that are refused
                             "2 0 0 0.5\n" + repeated("0 0 0 9\n", 2000) + "3 0 0 0.4\n4 0 0 -0.3\n";
    const std::string command = "propagate -t quat --interpolation cubic --on-error skip --diagnostics off";
    const auto at_once = run(command, rows);
    CHECK(count_rows(at_once.out) == 5);
    CHECK(run_in_pieces(command, rows, 5000) == at_once);
}

// Catches a row that waits for more than the second, and a state that is lost between batches.
TEST_CASE("differences answer each row as it comes, whatever the threads and the blocks") {
    Process process({"rates", "--differences", "-f", "rpy", "-p", "12"});
    process.write("0 0 0 0\n1 0 0 1\n");
    CHECK(process.read_rows(2) == "0 0 0 1\n1 0 0 1\n");
    process.write("2 0 0 1.5\n");
    CHECK(process.read_rows(1) == "2 0 0 0.5\n");
    CHECK(process.finish().exit_code == 0);
    std::string rows;
    for (int i = 0; i < 20'000; ++i) {
        rows += std::to_string(i) + " 0.5 " + std::to_string(i % 17) + "e-2 -1\n";
    }
    const std::string options = "rates --differences -f rotvec --diagnostics columns --threads ";
    const auto one = run(options + "1", rows);
    CHECK(one.exit_code == 0);
    CHECK(count_rows(one.out) == 20'000);
    CHECK(run(options + "8", rows) == one);
}
