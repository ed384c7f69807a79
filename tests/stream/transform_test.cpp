// The seam on which threads will work: what a block of rows becomes depends on nothing but the block.

#include <algorithm>
#include <random>
#include <string>

#include <rotconv/spec.hpp>

#include "catch.hpp"
#include "operations/operations.hpp"
#include "stream/row_transformer.hpp"

using namespace rotconv;
using namespace rotconv::stream;

namespace {

Options options_of(const char* from, const char* to, double tolerance = 1e-3) {
    const Spec spec = std::get<Spec>(parse_spec(from));
    const Conversion conversion(spec, std::get<Spec>(parse_spec(to)), {.tolerance = tolerance});
    return {.input = {.numbers = operations::attitude_numbers(spec)},
            .operation = operations::convert(conversion, false)};
}

/// Hands the text on in pieces of so many lines as `piece` says each time: take(text, first line).
template <class Piece, class Take> void in_pieces(std::string_view text, Piece piece, Take take) {
    std::size_t line = 1;
    while (!text.empty()) {
        std::size_t end = 0;
        std::size_t count = 0;
        for (const std::size_t lines = piece(); count < lines && end < text.size(); ++count) {
            end = text.find('\n', end) + 1;
        }
        take(text.substr(0, end), line);
        text.remove_prefix(end);
        line += count;
    }
}

/// A stream with comments, blank rows, errors and diagnostics in it.
std::string rows(int count) {
    std::mt19937_64 engine(91);
    std::normal_distribution<double> normal;
    std::string text;
    for (int i = 0; i < count; ++i) {
        switch (engine() % 12) {
        case 0: text += "# a comment\n"; break;
        case 1: text += "\r\n"; break;
        case 2: text += "x,1,zero,0,0\n"; break;
        case 3: text += "x,0,0,0,0\n"; break;
        case 4: text += "x,0,0,1,0\n"; break;
        case 5: text += "x,1\n"; break;
        default:
            text += fmt::format("t{},{},{},{},{}\n", i, normal(engine), normal(engine), normal(engine), normal(engine));
        }
    }
    return text;
}

std::string repeated(std::string_view text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i) {
        result += text;
    }
    return result;
}

std::string all_of(const Output& output) {
    std::string text = fmt::to_string(output.bytes);
    for (const Event& event : output.events) {
        if (const auto* error = std::get_if<RowError>(&event)) {
            text += fmt::format("{} {} {}\n", error->line, static_cast<int>(error->what), error->text);
        } else {
            const auto& diagnostic = std::get<Diagnostic>(event);
            text += fmt::format("{} {}\n", diagnostic.line, name_of(diagnostic.kind));
        }
    }
    return text;
}

} // namespace

// Would catch: state that leaks from one block into the next.
TEST_CASE("a stream cut at any line becomes the same") {
    Options options = options_of("quat", "rotvec", 1e9);
    options.on_error = OnError::nan;
    options.input.columns = std::get<ColumnList>(ColumnList::parse("2-5", 4));
    options.diagnostic_columns = true;
    const std::string text = rows(1500);
    Layout layout;
    layout.delimiter = Delimiter::character(',');
    layout.select(options.input.columns.positions(), 4, 0);
    RowTransformer whole(options, layout);
    Output expected;
    whole.transform(text, 1, expected);
    std::mt19937_64 engine(92);
    for (int round = 0; round < 5; ++round) {
        RowTransformer first(options, layout);
        RowTransformer second(options, layout);
        Output output;
        in_pieces(
            text, [&engine] { return 1 + engine() % 300; },
            [&](std::string_view piece, std::size_t line) {
                (engine() % 2 == 0 ? first : second).transform(piece, line, output);
            });
        CHECK(fmt::to_string(output.bytes) == fmt::to_string(expected.bytes));
        CHECK(all_of(output) == all_of(expected));
    }
}

// Would catch: rows that are held back for those after them, and get lost, doubled or out of order.
TEST_CASE("a stream whose rows wait for the next one becomes the same, cut at any line") {
    operations::PropagationRows propagation;
    propagation.settings.interpolation = Interpolation::cubic;
    propagation.stop_at_error = false;
    std::mt19937_64 engine(93);
    std::string text;
    for (int i = 0; i < 1500; ++i) {
        switch (engine() % 8) {
        case 0: text += "# a comment\n"; break;
        case 1: text += "x,0,0,0\n"; break;
        case 2: text += "-1,0,0,0\n"; break;
        default: text += fmt::format("{},{},0,1\n", i, engine() % 10);
        }
    }
    text += repeated("# many comments\n", 400) + "2000,0,0,1\n";
    const auto transformed = [&text, &propagation](const auto& piece) {
        Options options{.input = {.numbers = operations::propagation_numbers()},
                        .operation = operations::propagate(propagation)};
        options.on_error = OnError::nan;
        Layout layout;
        layout.delimiter = Delimiter::character(',');
        layout.select({}, 4, 1);
        RowTransformer transformer(options, layout);
        Output output;
        in_pieces(text, piece,
                  [&](std::string_view some, std::size_t line) { transformer.transform(some, line, output); });
        transformer.finish(output);
        return all_of(output);
    };
    const std::string whole = transformed([] { return std::size_t{100000}; });
    CHECK(std::ranges::count(whole, '\n') > 1901);
    CHECK(transformed([] { return std::size_t{1}; }) == whole);
    CHECK(transformed([&engine] { return static_cast<std::size_t>(1 + engine() % 300); }) == whole);
}

// Would catch: rows after an error that are written all the same.
TEST_CASE("an error under stop ends the block") {
    const Options options = options_of("quat", "quat");
    Layout layout;
    layout.select({}, 4, 0);
    RowTransformer transformer(options, layout);
    Output output;
    transformer.transform("1 0 0 0\n1 0 0\n0 1 0 0\n", 10, output);
    CHECK(output.stopped);
    CHECK(fmt::to_string(output.bytes) == "1 0 0 0\n");
    REQUIRE(output.events.size() == 1);
    CHECK(std::get<RowError>(output.events[0]).line == 11);
}
