// Pairs of rows are the same in whatever pieces the two streams arrive.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "catch.hpp"
#include "operations/operations.hpp"
#include "pieces.hpp"
#include "stream/pairs/pair_reader.hpp"

using namespace rotconv;
using namespace rotconv::stream;

namespace {

/// Rows of a key and a quaternion: their first fields.
InputOptions keyed() {
    return {.numbers = operations::pair_numbers(operations::attitude_numbers({}), {.paired = true, .by_key = true}),
            .columns = std::get<ColumnList>(ColumnList::parse("1-5", 5)),
            .delimiter = Delimiter::character(',')};
}

Options keyed_pairs(const std::string& within) {
    return {.input = keyed(),
            .operation = operations::compare(Comparison(Spec{}, Spec{}), {{.paired = true, .by_key = true}}),
            .pairing = Pairing{.reference = keyed(), .by_key = true, .within = read_distance(within)}};
}

/// The lines of each pair, `!` before those of an error, the unpaired rows, and how the reader ended early. Where the
/// reference is interpolated, also the line of the later neighbour and the fraction.
std::string pairs_of(const std::string& rows, const std::string& references, std::size_t piece,
                     const Options& options) {
    Pieces source(rows, {piece});
    Pieces reference(references, {piece});
    PairReader reader(source, reference, options, IoBlockReader::largest_block);
    std::string pairs;
    std::array<std::size_t, 2> unpaired{};
    for (bool more = true; more;) {
        Job job;
        more = reader.read(job);
        unpaired[0] += job.output.unpaired[0].rows;
        unpaired[1] += job.output.unpaired[1].rows;
        const ReadRows& read = job.pairs.read;
        for (std::size_t i = 0; i < read.rows.size(); ++i) {
            const Row& row = read.rows[i];
            const bool is_between =
                row.has_numbers() && options.pairing->interpolates && !read.between[row.index].is_at_row();
            if (!row.passes) {
                pairs += fmt::format(
                    "{}{}-{}{} ", row.has_numbers() ? "" : "!", row.number, read.pairs[i].partner.number,
                    is_between ? fmt::format("+{}@{}", read.pairs[i].later.number, read.between[row.index].fraction())
                               : "");
            }
        }
    }
    const auto error = reader.error();
    return pairs + fmt::format("{} {}", unpaired[0], unpaired[1]) +
           (error ? fmt::format(" ends at {}{}", error->place.is_in_reference() ? "-" : "", error->place.line) : "");
}

std::string pairs_of(const std::string& rows, const std::string& references, std::size_t piece = 1U << 16U,
                     const char* within = "0.5") {
    return pairs_of(rows, references, piece, keyed_pairs(within));
}

/// Keys of a stream and the text of its rows.
struct Stream {
    std::vector<long> keys; ///< whole numbers
    std::string text;

    [[nodiscard]] bool increases_at(std::size_t row) const {
        return std::all_of(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(row),
                           [this, row](long key) { return key < keys[row]; });
    }
};

Stream random_stream(std::mt19937& engine, int largest_step, const char* ending) {
    Stream stream;
    long key = 1'403'636'579'763'555'000;
    for (int i = 0; i < 25; ++i) {
        key += std::uniform_int_distribution(-1, largest_step)(engine); // some are repeated, or decrease
        stream.keys.push_back(key);
        stream.text += fmt::format("{}{},1,0,0,0\n", key, ending);
    }
    return stream;
}

} // namespace

// Catches an offset or a unit that is lost, a partner that is not the nearest, neighbours that are not those
// around a key, and any of these where a stream comes in pieces. The pairs are found anew by looking at all.
TEST_CASE("pairs with units, offsets and interpolation are those found by looking at all") {
    std::mt19937 engine(20261123);
    for (int round = 0; round < 300; ++round) {
        const auto random = [&engine](int from, int to) { return std::uniform_int_distribution(from, to)(engine); };
        const Stream own = random_stream(engine, random(1, 9), round % 3 == 0 ? ".0" : "");
        const Stream other = random_stream(engine, random(1, 9), "000"); // of a unit a thousandth as large
        const int offset = random(-9, 9);
        const int within = random(0, 9);
        const bool interpolates = round % 2 == 0;
        Options options = keyed_pairs(fmt::format("{}e-6", within));
        options.input.key_power = -6;
        options.input.key_offset = read_key(fmt::format("{}e-6", offset)).value;
        options.pairing->reference.key_power = -9;
        options.pairing->interpolates = interpolates;

        std::vector<std::size_t> references;
        for (std::size_t i = 0; i < other.keys.size(); ++i) {
            if (other.increases_at(i)) {
                references.push_back(i);
            }
        }
        const auto distance = [&](std::size_t i, std::size_t j) {
            return std::abs(own.keys[i] + offset - other.keys[j]);
        };
        std::string expected;
        std::size_t unpaired = 0;
        std::size_t paired = 0;
        for (std::size_t i = 0; i < own.keys.size(); ++i) {
            if (!own.increases_at(i)) {
                expected += fmt::format("!{}-0 ", i + 1);
                continue;
            }
            const std::string before = expected;
            const long key = own.keys[i] + offset;
            if (interpolates) {
                for (std::size_t k = 0; k < references.size(); ++k) {
                    const long earlier = other.keys[references[k]];
                    const long later = k + 1 < references.size() ? other.keys[references[k + 1]] : earlier;
                    if (earlier == key) {
                        expected += fmt::format("{}-{} ", i + 1, references[k] + 1);
                    } else if (earlier < key && key < later && later - earlier <= within) {
                        expected +=
                            fmt::format("{}-{}+{}@{} ", i + 1, references[k] + 1, references[k + 1] + 1,
                                        static_cast<double>(key - earlier) / static_cast<double>(later - earlier));
                    }
                }
            } else if (!references.empty()) {
                const std::size_t best =
                    *std::ranges::min_element(references, {}, [&](auto j) { return distance(i, j); });
                bool is_nearest = distance(i, best) <= within;
                for (std::size_t n = 0; n < own.keys.size(); ++n) {
                    const bool is_nearer =
                        n < i ? distance(n, best) <= distance(i, best) : distance(n, best) < distance(i, best);
                    is_nearest = is_nearest && !(own.increases_at(n) && is_nearer);
                }
                expected += is_nearest ? fmt::format("{}-{} ", i + 1, best + 1) : "";
            }
            ++(expected == before ? unpaired : paired);
        }
        expected += fmt::format("{} {}", unpaired, interpolates ? 0 : references.size() - paired);
        for (const std::size_t piece : {std::size_t{1} << 16U, static_cast<std::size_t>(round % 70 + 1)}) {
            std::string found = pairs_of(own.text, other.text, piece, options);
            std::size_t failed = 0;
            for (std::size_t at = 0; (at = found.find("!0-0 ")) != std::string::npos; ++failed) { // of the reference
                found.erase(at, 5);
            }
            INFO(own.text << "\n" << other.text << offset << " " << within << " in pieces of " << piece);
            CHECK(found == expected);
            CHECK(failed == other.keys.size() - references.size());
        }
    }
}

// Catches a fraction of doubles, which would be 0, and one that overflows.
TEST_CASE("the fraction between two keys has all their digits") {
    Options options = keyed_pairs("1e999");
    options.pairing->interpolates = true;
    CHECK(pairs_of("1403636579763555584.25,1,0,0,0\n", "1403636579763555584,1,0,0,0\n1403636579763555585,1,0,0,0\n",
                   1U << 16U, options) == "1-1+2@0.25 0 0");
    CHECK(pairs_of("25e18,1,0,0,0\n", "0,1,0,0,0\n99999999999999999999,1,0,0,0\n", 1U << 16U, options) ==
          "1-1+2@0.25 0 0");
    CHECK(pairs_of("1e-18,1,0,0,0\n", "0,1,0,0,0\n4e-18,1,0,0,0\n", 1U << 16U, options) == "1-1+2@0.25 0 0");
}

// Catches rows of the reference that are held, and a neighbour that is looked for without end.
TEST_CASE("a row whose later neighbour is too far ends the pairing") {
    Options options = keyed_pairs("9");
    options.pairing->interpolates = true;
    std::string references = "1,1,0,0,0\n";
    for (int i = 0; i < 5000; ++i) {
        references += "# remark\n";
    }
    references += "2,1,0,0,0\n";
    CHECK(pairs_of("1.5,1,0,0,0\n", references, 1U << 16U, options) == "0 0 ends at -1");
    CHECK(pairs_of("1,1,0,0,0\n", references, 1U << 16U, options) == "1-1 0 0"); // the reference has that key
}

// Catches a row that is paired with one that is not its nearest, because the nearest comes late.
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

// Catches a difference of keys of which not all digits count, and a key whose size is not checked.
TEST_CASE("keys are the nearest to each other by all their digits") {
    const std::string rows = "3e-18,1,0,0,0\n9e19,1,0,0,0\n";
    const auto reference = [](char last) {
        return "3e-18,1,0,0,0\n" + std::string("89999999999999999999.99999999999999999") + last + ",1,0,0,0\n";
    };
    // 9e19 is 4e-18 away from the first; the key 3e-18 of the other row is 9e19 - 7e-18 away
    CHECK(pairs_of(rows, reference('6'), 1U << 16U, "1e21") == "1-1 2-2 0 0");
    CHECK(pairs_of(rows, reference('6'), 1U << 16U, "4e-18") == "1-1 2-2 0 0");
    CHECK(pairs_of(rows, reference('6'), 1U << 16U, "3e-18") == "1-1 1 1");
    CHECK(pairs_of("1e20,1,0,0,0\n", rows) == "!1-0 0 2");
}
