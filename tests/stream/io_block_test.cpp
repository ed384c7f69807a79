// Blocks of whole lines, however the bytes arrive.

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "pieces.hpp"
#include "stream/bytes/io_block.hpp"

using namespace rotconv::stream;

namespace {

std::string all_of(Source& source) {
    IoBlockReader reader(source);
    std::string text;
    std::size_t line = 1;
    for (IoBlock block; reader.read(block);) {
        if (!block.text.empty()) {
            CHECK(block.first_line == line);
        }
        line += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
        text += block.text;
    }
    CHECK_FALSE(reader.error());
    return text;
}

} // namespace

// Catches bytes lost, doubled or counted wrong where a read ends inside a line.
TEST_CASE("blocks together are the input however it arrives") {
    std::mt19937_64 engine(81);
    std::string text = "\n\n1 2 3\r\n";
    for (int i = 0; i < 3000; ++i) {
        text += std::string(engine() % (i % 100 == 0 ? 9000 : 60), static_cast<char>('a' + i % 26)) + "\n";
    }
    text += "no newline";
    for (int round = 0; round < 20; ++round) {
        std::vector<std::size_t> sizes(100);
        for (auto& size : sizes) {
            size = 1 + engine() % (round < 10 ? 7 : 30000);
        }
        Pieces pieces(text, sizes);
        REQUIRE(all_of(pieces) == text);
    }
}

// Catches a mark that becomes a part of the first field, or a text that is taken for one.
TEST_CASE("a byte order mark is left out at the start alone") {
    for (std::size_t first = 1; first < 6; ++first) {
        Pieces marked("\xEF\xBB\xBF"
                      "1,2\n\xEF\xBB\xBF\n",
                      {first, 100});
        CHECK(all_of(marked) == "1,2\n\xEF\xBB\xBF\n");
        Pieces cut("\xEF\xBB", {first});
        CHECK(all_of(cut) == "\xEF\xBB");
    }
    Pieces empty("", {1});
    CHECK(all_of(empty).empty());
}

// Catches a limit that is off by one, or rows before the long line that are lost.
TEST_CASE("the longest line is 4 MiB") {
    const std::string longest(IoBlockReader::longest_line, 'x');
    for (const std::string end : {"\n", "\n1\n", ""}) {
        Pieces fits("1 2\n" + longest + end, {7, 100'000});
        CHECK(all_of(fits).size() == 4 + longest.size() + end.size());
        Pieces too_long("1 2\n" + longest + "y" + end, {7, 100'000});
        IoBlockReader reader(too_long);
        IoBlock block;
        CHECK(reader.read(block));
        CHECK(block.text == "1 2\n");
        while (reader.read(block)) {
            CHECK(block.text.empty());
        }
        REQUIRE(reader.error());
        CHECK(reader.error()->what == StreamError::What::line_too_long);
        CHECK(reader.error()->place.line == 2);
    }
}

// Catches a carriage return that stays in the last field or is lost from the output.
TEST_CASE("a line is cut before its line end") {
    std::string_view text = "a\r\n\nb\r";
    const Line first = next_line(text);
    CHECK(first.text == "a");
    CHECK(first.end == "\r\n");
    CHECK(next_line(text).text.empty());
    const Line last = next_line(text);
    CHECK(last.text == "b\r");
    CHECK(last.end.empty());
    CHECK(text.empty());
}
