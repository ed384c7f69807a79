// Pairs of rows are the same in whatever pieces the two streams arrive.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "catch.hpp"
#include "operations/operations.hpp"
#include "stream/pair_reader.hpp"

using namespace rotconv;
using namespace rotconv::stream;

namespace {

/// A text, so many bytes a read.
class Pieces final : public Source {
public:
    Pieces(std::string_view text, std::size_t piece) : rest_(text), piece_(piece) {}
    std::ptrdiff_t read(std::span<char> to) override {
        const std::size_t count = std::min({piece_, to.size(), rest_.size()});
        std::copy_n(rest_.data(), count, to.data());
        rest_.remove_prefix(count);
        return static_cast<std::ptrdiff_t>(count);
    }

private:
    std::string_view rest_;
    std::size_t piece_;
};

/// Rows of a key and a quaternion: their first fields.
InputOptions keyed() {
    return {.numbers = operations::attitude_numbers(Spec{}, true),
            .columns = std::get<ColumnList>(ColumnList::parse("1-5", 5)),
            .delimiter = Delimiter::character(',')};
}

std::string pairs_of(std::string_view rows, std::string_view references, std::size_t piece) {
    const Options options{.input = keyed(),
                          .operation =
                              operations::compare(Comparison(Spec{}, Spec{}), {.paired = true, .by_key = true}),
                          .pairing = Pairing{.reference = keyed(), .by_key = true, .within = *Decimal::parse("0.5")}};
    Pieces source(rows, piece);
    Pieces reference(references, piece);
    PairReader reader(source, reference, options, IoBlockReader::largest_block);
    std::string pairs;
    for (bool more = true; more;) {
        Job job;
        more = reader.read(job);
        for (const PairedRow& row : job.pairs.rows) {
            pairs +=
                fmt::format("{}{}-{} ", row.error != PairedRow::no_error ? "!" : "", row.number, row.reference_number);
        }
    }
    const auto unpaired = reader.unpaired();
    return pairs + fmt::format("{} {}", unpaired[0].rows, unpaired[1].rows);
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
    const std::string whole = pairs_of(rows, references, 1U << 16U);
    CHECK(whole.find("43-1 ") != std::string::npos); // the nearest: line 43, not line 2
    CHECK(whole.ends_with(" 2 1"));
    for (std::size_t piece = 1; piece <= 60; ++piece) {
        INFO("pieces of " << piece);
        CHECK(pairs_of(rows, references, piece) == whole);
    }
}
