#include <cmath>
#include <fstream>

#include <sys/stat.h>

#include <catch.hpp>
#include <fmt/format.h>

#include "process.hpp"

using namespace program;

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
