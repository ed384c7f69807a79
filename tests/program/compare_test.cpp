#include <cmath>
#include <fstream>
#include <random>

#include <sys/stat.h>

#include <catch.hpp>
#include <fmt/format.h>

#include "process.hpp"

using namespace program;

// Catches a greedy match, and ties that are decided by chance. The pairs are found anew by looking at all.
TEST_CASE("each row is paired with the nearest whose nearest it is") {
    std::mt19937 engine(7);
    Files files;
    for (int round = 0; round < 60; ++round) {
        const int within = std::uniform_int_distribution(0, 6)(engine);
        std::vector<std::vector<int>> keys(2);
        for (std::size_t side = 0; side < 2; ++side) {
            std::string text;
            for (int key = 0, i = 0; i < 40; ++i) {
                key += std::uniform_int_distribution(1, round % 9 + 1)(engine);
                keys[side].push_back(key);
                text += fmt::format("{}.{} 0 0 {}\n{}", key / 10, key % 10, side == 0 ? 0.0 : 1e-3 * i,
                                    i % 7 == round % 7 ? "# remark\n" : "");
            }
            files.add(side == 0 ? "new" : "old", text);
        }
        const auto nearest = [&](std::size_t side, std::size_t row) {
            const auto& others = keys[1 - side];
            std::size_t best = 0;
            for (std::size_t i = 1; i < others.size(); ++i) {
                const auto apart = [&](std::size_t at) { return std::abs(others[at] - keys[side][row]); };
                best = apart(i) < apart(best) ? i : best;
            }
            return best;
        };
        std::string expected;
        for (std::size_t i = 0; i < keys[0].size(); ++i) {
            const std::size_t other = nearest(0, i);
            if (std::abs(keys[0][i] - keys[1][other]) <= within && nearest(1, other) == i) {
                expected += fmt::format("{}:{} ", i, other);
            }
        }
        const auto result = files(
            fmt::format("compare -f rotvec --key 1 --columns 2-4 --key-within 0.{} --format csv @new @old", within));
        std::string pairs;
        for (const auto& line : fields_of(result.out, '\n')) {
            if (!line.empty() && !line.starts_with('#')) {
                const auto words = words_of(line);
                const int key = static_cast<int>(std::lround(std::stod(words.front()) * 10));
                pairs += fmt::format("{}:{} ", std::ranges::find(keys[0], key) - keys[0].begin(),
                                     std::lround(std::stod(words.at(4)) * 1000));
            }
        }
        CHECK(pairs == expected);
    }
}

// Catches sums in another order, pairs that shift where blocks end, and a file that is held.
TEST_CASE("compare gives the same bytes with any number of threads, and needs no memory for its length") {
    Files files;
    std::string rows;
    std::string others;
    for (int i = 0; i < 60'000; ++i) {
        rows += fmt::format("{} {} {} {}\n", i, std::sin(i), std::cos(3 * i), 0.1 * std::sin(7 * i));
        others += fmt::format("{}, {}, {}, {}, more text to make blocks of other lengths\n", i + 0.25, std::sin(i),
                              std::cos(3 * i), 0.1 * std::sin(7 * i + 1e-3 * std::sin(11 * i)));
        if (i % 1000 == 0) {
            rows += "# remark\n";
        }
    }
    files.add("new", rows).add("old", others);
    for (const std::string options : {"--columns 2-4 --format csv", "--columns 2-4 --format json",
                                      "--columns 2-4 --key 1 --key-within 0.3 --format csv",
                                      "--columns 2-4 --key 1 --key-within 1 --interpolate --key-offset 0.3 "
                                      "--format csv"}) {
        const auto one = files("compare -f rotvec --threads 1 " + options + " @new @old");
        CHECK(one.exit_code ==
              (options.find("interpolate") == std::string::npos ? 0 : 1)); // nothing comes after the last
        CHECK(one.out.size() > 100);
        for (const char* threads : {"2", "5"}) {
            CHECK(files("compare -f rotvec " + options + " @new @old --threads " + threads) == one);
        }
    }
}

// Catches rows that are held: by row, by keys that are equal, and by keys whose next one must be seen.
TEST_CASE("the memory of compare does not grow with the streams") {
    Files files;
    for (const std::string options :
         {"", "--key 1 ", "--key 1 --key-within 0.5 ", "--key 1 --key-within 1.2 --interpolate --key-offset 0.6 "}) {
        std::vector<long> peaks;
        for (const int count : {20'000, 200'000}) {
            std::string rows;
            std::string others;
            for (int i = 0; i < count; ++i) {
                rows += std::to_string(i) + " 0.5 -0.5 0.5 0.5\n";
                others += std::to_string(i) + (options.find("within") == std::string::npos ? "" : ".1") +
                          " 0.5 -0.5 0.5 0.5\n";
            }
            if (options.find("interpolate") != std::string::npos) {
                others += std::to_string(count) + " 0.5 -0.5 0.5 0.5\n";
            }
            files.add("old", others);
            Process process(
                words_of("compare -f quat --threads 1 --columns 2-5 " + options + "- " + files.path("old")));
            peaks.push_back(process.peak_memory_after(rows));
            const auto result = process.finish();
            CHECK(result.exit_code == 0);
            CHECK(missing(result.out, {"rows      " + std::to_string(count) + "\n"}) == "");
        }
        INFO(options);
        CHECK((is_sanitized || peaks[1] <= peaks[0] + 512));
    }
    // long stretches without a partner, in the stream and in the reference
    std::string sparse;
    for (int i = 0; i < 200'000; i += 20'000) {
        sparse += std::to_string(i) + " 0.5 -0.5 0.5 0.5\n";
    }
    std::string dense;
    for (int i = 0; i < 200'000; ++i) {
        dense += std::to_string(i) + " 0.5 -0.5 0.5 0.5\n";
    }
    for (const bool first : {true, false}) {
        files.add("old", first ? sparse : dense);
        Process process(words_of("compare -f quat --key 1 --columns 2-5 --threads 1 - " + files.path("old")));
        const long peak = process.peak_memory_after(first ? dense : sparse);
        CHECK(missing(process.finish().out, {"rows      10\n"}) == "");
        CHECK((is_sanitized || peak < 9'000)); // of 5 MB of rows
    }
}

// Catches a wrong pair, and memory that grows with what stands between two keys.
TEST_CASE("a row whose partner cannot be told ends the comparison") {
    Files files;
    const std::string options = "compare -f quat --key 1 --columns 2-5 --key-within 0.5 --format csv @new @old";
    files.add("old", "1.1 1 0 0 0\n");
    files.add("new", "1 1 0 0 0\n" + repeated("# remark\n", 4'000) + "1.1 1 0 0 0\n");
    CHECK(files(options) == went_on(repeated("# remark\n", 4'000) + "1.1 1 0 0 0 0 1 1.1 0\n",
                                    {"new: unpaired: 1 row, first at line 1\n"}));
    files.add("new", "1 1 0 0 0\n" + repeated("# remark\n", 200'000) + "1.1 1 0 0 0\n");
    CHECK(files(options) == stopped("", {"new:1: the row cannot be paired: too many comments and failed rows stand "
                                         "before the next key\n"}));
}

// Catches a comparison that waits for full blocks.
TEST_CASE("a pair that has arrived is answered") {
    Files files;
    files.add("old", "0 0 0\n0 0 0\n0 0 0\n");
    Process process(Words{"compare", "-f", "rotvec", "--format", "csv", "-", files.path("old")});
    process.write("0 0 0\n");
    CHECK(process.read_rows(1) == "0 0 0 0\n");
    process.write("0 0 0.5\n0 0");
    CHECK(process.read_rows(1) == "0 0 0.5 0.5\n");
    process.write(" 0\n");
    CHECK(process.read_rows(1) == "0 0 0 0\n");
    CHECK(process.finish().exit_code == 0);
}

// Catches a row that waits for the row after it, and a neighbour that is waited for though the key is met.
TEST_CASE("an interpolated reference is answered as soon as its later row has come") {
    Files files;
    REQUIRE(::mkfifo(files.path("fifo").c_str(), 0600) == 0);
    Process process(Words{"compare", "-f", "rotvec", "--key", "1", "--columns", "2-4", "--interpolate", "--key-within",
                          "2", "--format", "csv", "-p", "6", "-", files.path("fifo")});
    std::ofstream reference(files.path("fifo"));
    process.write("1 0 0 0.25\n2 0 0 0\n");
    reference << "1 0 0 0\n" << std::flush;
    CHECK(process.read_rows(1) == "1 0 0 0.25 0.25 1 1 0\n");
    reference << "3 0 0 " << std::flush;
    reference << "1\n" << std::flush;
    CHECK(process.read_rows(1) == "2 0 0 0 0.5 1 1 1\n");
    process.write("2.5 0 0 0");
    process.write("\n");
    CHECK(process.read_rows(1) == "2.5 0 0 0 0.75 1 1 1.5\n");
    reference.close();
    process.write("3 0 0 0\n3.5 0 0 0\n");
    const auto result = process.finish();
    CHECK(result.out == "3 0 0 0 1 2 3 0\n");
    CHECK(result.err == "rotconv: -: unpaired: 1 row, first at line 5\n");
    CHECK(result.exit_code == 1);
}

// Catches fields that get into the sums.
TEST_CASE("rows of doubles are compared too") {
    Files files;
    files.add("new", bytes_of({7, 0, 0, 0, 8, 0, 0, 0.25})).add("old", bytes_of({7, 0, 0, 0, 8, 0, 0, 0}));
    const std::string options = "compare -f rotvec --input-format f64 --width 4 --columns 2-4 --within 0.25rad ";
    CHECK(missing(files(options + "@new @old").out, {"max       0.25 rad at 2\nrms       0.176777 rad\n"}) == "");
    CHECK(missing(files(options + "--key 1 @new @old").out, {"rows      2\n", "max       0.25 rad at 2 (key 8)\n"}) ==
          "");
    CHECK(files(options + "--format csv @new @old") == done("7,0,0,0,0\n8,0,0,0.25,0.25\n"));
    files.add("old", bytes_of({7, 0, 0, 0, 7.1, 0, 0, 0, 9, 0, 0, 1}));
    CHECK(files(options + "--format csv --key 1 --key-within 1.9 --interpolate --key-offset 0.05 -p 6 @new @old").out ==
          "7,0,0,0,0,1,7,0.05\n8,0,0,0.25,0.25,2,7.1,0.95\n");
    files.add("old", bytes_of({7, 0, 0, 0, 8, 0, 0, 0}));
    files.add("old", bytes_of({7, 0, 0, 0, 8, 0, 0}));
    CHECK(missing(files(options + "@new @old").err, {"old:2: the row that begins at byte 32 is not whole"}) == "");
    CHECK(files(options + "@new @old").exit_code == 2);
}

// Catches a check that goes on, and then fails because nobody reads, or says so.
TEST_CASE("a reader that closes the pipe ends a comparison and an identification quietly") {
    Files files;
    files.add("old", repeated("0.5 -0.5 0.5 0.5\n", 1000));
    for (const std::string& arguments : {"compare -f quat --format csv - " + files.path("old"),
                                         "compare -f quat - " + files.path("old"), std::string("identify -t quat")}) {
        Process process(words_of(arguments));
        process.close_output(); // before there is anything to write
        process.write(repeated(arguments.starts_with("c") ? "0.5 -0.5 0.5 0.5\n" : "0 0 1 1 0 0 0\n", 1000));
        const auto result = process.finish();
        INFO(arguments);
        CHECK(result.exit_code == 0);
        CHECK(result.err == "");
    }
}
