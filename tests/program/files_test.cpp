#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <catch.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "process.hpp"

using namespace program;

// Catches output that is kept until the end.
TEST_CASE("an output file is written as soon as there are rows") {
    const Folder folder;
    const auto out = folder / "out";
    Process process(words_of(reorder + "-o " + out.string()));
    process.write("1 0 0 0\n");
    for (int i = 0; i < 1000 && (!std::filesystem::exists(out) || read_file(out).empty()); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    CHECK(read_file(out) == "0 0 0 1\n");
    CHECK(process.finish() == done(""));
}

// Catches a full disk that a network's file system tells of only then.
TEST_CASE("an error that comes when the output is closed is an error of the run") {
    const Surroundings fails{.close_error = ENOSPC};
    for (const char* arguments : {"-f quat -t quat 1 0 0 0", "-f quat -t quat", "survey -f quat", "--help", "list"}) {
        INFO(arguments);
        const auto result = run(arguments, "1 0 0 0\n", fails);
        CHECK(result.exit_code == 2);
        CHECK(missing(result.err, {"rotconv: -: cannot be written: No space left on device"}) == "");
        CHECK(result.out != "");
    }
}

// Catches a file that is emptied before it is read.
TEST_CASE("the same file for input and output is refused and kept") {
    const Folder folder;
    const auto file = folder / "file";
    const auto link = folder / "link";
    const auto hard_link = folder / "hard-link";
    const std::string bytes = "1 0 0 0\n";
    write_file(file, bytes);
    std::filesystem::create_symlink(file, link);
    std::filesystem::create_hard_link(file, hard_link);
    const std::string path = file.string();
    for (const auto& other : {path, (folder / "./file").string(), link.string(), hard_link.string()}) {
        CHECK(run(reorder + "-i " + path + " -o " + other) == stopped(any_output, {"rotconv: "}));
        CHECK(read_file(file) == bytes);
    }
    // the shell's redirection
    CHECK(run(reorder + "-o " + path, {}, {.input_file = file}).exit_code == 2);
    CHECK(read_file(file) == bytes);
}

// Catches a failed write that nobody looked at.
TEST_CASE("a full disk ends the run with exit 2") {
    CHECK(run(reorder + "-o /dev/full", "1 0 0 0\n") == stopped(any_output, {"rotconv: ", "/dev/full"}));
    const Surroundings full{.output_file = "/dev/full"};
    CHECK(run(reorder + "1 0 0 0", {}, full).exit_code == 2);
    CHECK(run(reorder, "1 0 0 0\n", full).exit_code == 2);
    for (const std::string threads : {"1", "2", "8"}) {
        CHECK(run(reorder + "--threads " + threads, repeated("1 0 0 0\n", 100'000), full).exit_code == 2);
    }
    CHECK(run("--help", {}, full).exit_code == 2);
    CHECK(run("list", {}, full).exit_code == 2);
    CHECK(missing(run(reorder, "1 0 0 0\n", full).err, {"rotconv: "}) == "");
}

// Catches death by an exception out of a message, which changes the exit code and loses rows.
TEST_CASE("a stderr that cannot be written does not kill the program") {
    const Surroundings full{.errors_file = "/dev/full"};
    CHECK(run(reorder, "1 0 0 0\n0 0 0 0\n", full) == Result{2, "0 0 0 1\n", {}});
    CHECK(run(reorder + "0 0 0 0", {}, full).exit_code == 2);
    CHECK(run("-f quat -t nothing 1 0 0 0", {}, full).exit_code == 2);
    const auto skipped = run(reorder + "--on-error skip", "0 0 0 0\n1 0 0 0\n", full);
    CHECK(skipped.exit_code > 0); // 1, or 2 for the full disk
    CHECK(skipped.out == "0 0 0 1\n");
    const auto half_turn = run("-f quat -t mrp", "0 1 0 0\n1 0 0 0\n", full);
    CHECK(half_turn.exit_code >= 0);
    CHECK(half_turn.out == "1 0 0\n0 0 0\n");
}

// Catches help, lists and VALUEs that do not know of closed pipes.
TEST_CASE("a reader that left before the first row ends the run quietly") {
    for (const char* arguments :
         {"-f quat -t dcm", "-f quat -t dcm 1 0 0 0", "survey -f quat --condition 0.1", "--help", "list"}) {
        Process process(words_of(arguments));
        process.close_output();
        process.write("1 0 0 0\n");
        const auto result = process.finish();
        CHECK(result.exit_code == 0);
        CHECK(result.err == "");
    }
}

// Catches a long run that looks like one that hangs, and a terminal that is left with half a line.
TEST_CASE("a large file shows its progress on a terminal, whatever the command") {
    const Folder folder;
    const auto file = (folder / "large.csv").string();
    const std::string rows = repeated("0.5 0.5 0.5 0.5\n", is_sanitized ? 120'000 : 400'000);
    write_file(file, rows);
    const auto rates = (folder / "rates").string();
    std::string motion;
    for (int i = 0; i < (is_sanitized ? 90'000 : 300'000); ++i) {
        motion += std::to_string(i) + " 0 0 1e-3\n";
    }
    write_file(rates, motion);
    const auto shown_by = [&](const std::string& command, std::string_view input) {
        const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
        REQUIRE(terminal >= 0);
        REQUIRE(::grantpt(terminal) == 0);
        REQUIRE(::unlockpt(terminal) == 0);
        Process process(words_of(command), {.errors_file = ::ptsname(terminal)});
        std::this_thread::sleep_for(std::chrono::milliseconds(1300)); // it waits for its reader, or for input
        process.write(input);
        CHECK(process.finish().exit_code == 0);
        std::string shown;
        std::array<char, 4096> bytes{};
        for (auto count = ::read(terminal, bytes.data(), bytes.size()); count > 0; // then the program has left it
             count = ::read(terminal, bytes.data(), bytes.size())) {
            shown.append(bytes.data(), static_cast<std::size_t>(count));
        }
        ::close(terminal);
        return shown;
    };
    for (const std::string& shown :
         {shown_by("-f quat -t dcm --threads 1 " + file, ""), shown_by("compare -f quat " + file + " -", rows),
          shown_by("propagate -t rpy --substeps 10 " + rates, "")}) {
        CHECK(missing(shown, {"rotconv: ", " %, ", " rows, ", " rows/s, ", " s left"}) == "");
        CHECK(shown.ends_with("\033[K"));
    }
    CHECK(run("-f quat -t quat -o /dev/null " + file).err == ""); // no terminal
    CHECK(run("propagate -t rpy -o /dev/null " + rates).err == "");
}
