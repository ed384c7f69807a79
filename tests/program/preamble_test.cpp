// Files as other programs write them: what stands before their rows, and what is said of it. The formats are theirs,
// the rows are ours.

#include <fmt/format.h>

#include "usage.hpp"

using namespace program;

namespace {

/// What is said of a file that is read as it is.
std::string told(const std::string& options, const std::string& text) {
    const Folder folder;
    const auto file = (folder / "data.log").string();
    write_file(file, text);
    Words words = words_of(options);
    words.push_back(file);
    const auto result = run(words);
    INFO(result);
    CHECK(result.exit_code == 2);
    CHECK(count_rows(result.err) == 1);
    std::string message = result.err;
    for (auto found = message.find(file); found != std::string::npos; found = message.find(file)) {
        message.erase(found, file.size());
        message.insert(found, 1, '@');
    }
    return message;
}

} // namespace

TEST_CASE("remarks of other programs are no header, and what leaves them out is told") {
    // Catches a remark with as many words as the row has numbers, which passes for a header.
    for (const std::string mark : {"//", "%"}) {
        CHECK(missing(told("-f quat -t rpy", fmt::format("{} made by us\n1 0 0 0\n", mark)),
                      {fmt::format("@:1: not a number: '{}'; ", mark),
                       fmt::format("lines that begin with {0} are not rows: add --comment ", mark)}) == "");
        CHECK(run("-f quat -t rpy", fmt::format("{} made by us\n", mark)).out == "");
        CHECK(run("-f quat -t rpy --header yes", fmt::format("{} made by us\n1 0 0 0\n", mark)).exit_code ==
              0); // if you say so
        // ... or if it has all the names
        CHECK(run("-f quat -t rpy --columns qw,qx,qy,qz", fmt::format("{} qw qx qy qz\n1 0 0 0\n", mark)) ==
              done(fmt::format("{} roll pitch yaw\n0 0 0\n", mark)));
    }
}

TEST_CASE("files with decimal commas are told so") {
    // Catches a message that leaves it to the reader to see it.
    for (const std::string rows : {"0,5;0,5;0,5;0,5\n", "qw;qx;qy;qz\n0,5;0,5;0,5;0,5\n", "0,5\t0,5\t0,5\t0,5\n"}) {
        CHECK(missing(told("-f quat -t rpy", rows), {"decimal commas into points: tr , . < @ | rotconv ..."}) == "");
    }
    CHECK(missing(told("-f quat -t rpy --delimiter semicolon", "0,5;0,5;0,5;0,5\n"), {"'0,5'; ", "decimal commas"}) ==
          "");
    CHECK(run("-f quat -t rpy -d", "0.5;0.5;0.5;0.5\n") == done("90;0;90\n"));
}

TEST_CASE("advice is for the beginning of a file") {
    // Catches a word about a header where a row far below is bad, or where there is nothing to advise.
    for (const std::string rows :
         {"1 0 0 0\n% 1 0 0\n", "1 0 0 x\n", "1 0 0 0\n1 0 0\n", "qw qx qy qz\n1 0 0 0\n// a b c\n"}) {
        CHECK(told("-f quat -t rpy", rows).find(';') == std::string::npos);
    }
    const auto result = run("-f quat -t rpy --on-error skip", "% a b c\n% d e f\n1 0 0 0\n");
    CHECK(result.out == "0 0 0\n");
    CHECK(count_rows(result.err) == 2);
    CHECK(run("-f quat -t rpy % 0 0 0").exit_code == 2);
}
