// Pairs of rows are the same in whatever pieces the two streams arrive.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "catch.hpp"
#include "operations/operations.hpp"
#include "pieces.hpp"
#include "stream/pair_reader.hpp"

using namespace rotconv;
using namespace rotconv::stream;

namespace {

/// Rows of a key and a quaternion: their first fields.
InputOptions keyed() {
    return {.numbers = operations::attitude_numbers(Spec{}, true),
            .columns = std::get<ColumnList>(ColumnList::parse("1-5", 5)),
            .delimiter = Delimiter::character(',')};
}

/// The lines of each pair, `!` before those of an error, the unpaired rows, and how the reader ended early.
std::string pairs_of(const std::string& rows, const std::string& references, std::size_t piece = 1U << 16U,
                     const char* within = "0.5") {
    const Options options{.input = keyed(),
                          .operation =
                              operations::compare(Comparison(Spec{}, Spec{}), {.paired = true, .by_key = true}),
                          .pairing = Pairing{.reference = keyed(), .by_key = true, .within = *Decimal::parse(within)}};
    Pieces source(rows, {piece});
    Pieces reference(references, {piece});
    PairReader reader(source, reference, options, IoBlockReader::largest_block);
    std::string pairs;
    for (bool more = true; more;) {
        Job job;
        more = reader.read(job);
        for (const Row& row : job.pairs.rows) {
            if (!row.passes) {
                pairs += fmt::format("{}{}-{} ", row.has_numbers() ? "" : "!", row.number, row.reference_number);
            }
        }
    }
    const auto unpaired = reader.unpaired();
    const auto error = reader.error();
    return pairs + fmt::format("{} {}", unpaired[0].rows, unpaired[1].rows) +
           (error ? fmt::format(" ends at {}{}", error->of_reference ? "-" : "", error->line) : "");
}

} // namespace

// Would catch: a limit of the look ahead that counts reads, or blocks that hold no whole line: then a row is paired
// with one that is not its nearest when it comes through a slow pipe.
TEST_CASE("rows are paired alike in whatever pieces they arrive") {
    std::string rows = "1,1,0,0,0\n1.5,1,0,0,0\n";
    for (int i = 0; i < 40; ++i) { // of which none may be paired
        rows += i % 2 == 0 ? "# a comment in between\n" : "1.25,1,0,0,0\n";
    }
    rows += "1.75,1,0,0,0\n";
    const std::string references = "1.75,1,0,0,0\n9,1,0,0,0\n";
    const std::string whole = pairs_of(rows, references);
    CHECK(whole.find("43-1 ") != std::string::npos); // the nearest: line 43, not line 2
    CHECK(whole.ends_with(" 2 1"));
    for (std::size_t piece = 1; piece <= 60; ++piece) {
        INFO("pieces of " << piece);
        CHECK(pairs_of(rows, references, piece) == whole);
    }
}

// Would catch: a row that is paired with one that is not its nearest, because the nearest comes late.
TEST_CASE("a row whose next one is too far ends the pairing, and is not paired") {
    const auto between = [](const std::string& line, int count) {
        std::string rows = "1,1,0,0,0\n";
        for (int i = 0; i < count; ++i) {
            rows += line;
        }
        return rows + "1.25,1,0,0,0\n";
    };
    const std::string references = "1.3,1,0,0,0\n";
    for (const std::string line : {"# remark\n", "\n", "1,1,0,0,0\n"}) {
        INFO(line);
        CHECK(pairs_of(between(line, 4000), references).ends_with("4002-1 1 0"));
        CHECK(pairs_of(between(line, 5000), references) == "0 0 ends at 1");
        CHECK(pairs_of(references, between(line, 5000)) == "0 0 ends at -1");
        CHECK(pairs_of(between(line, 5000), "1,1,0,0,0\n").starts_with("1-1 ")); // the next does not matter
    }
    CHECK(pairs_of(between("# " + std::string(1 << 20, 'x') + "\n", 2), references) == "0 0 ends at 1");
}

// Would catch: a difference of keys of which not all digits count.
TEST_CASE("keys are the nearest to each other by all their digits") {
    const std::string rows = "3,1,0,0,0\n1e900,1,0,0,0\n";
    const auto reference = [](char last) { return "3,1,0,0,0\n1" + std::string(899, '9') + last + ",1,0,0,0\n"; };
    CHECK(pairs_of(rows, reference('6'), 1U << 16U, "1e901") == "1-1 2-2 0 0"); // 1e900 - 4 away; 3 is 1e900 - 3 away
    CHECK(pairs_of(rows, reference('8'), 1U << 16U, "1e901") == "1-1 1 1");     // 1e900 - 2 away
}
