// The seam on which threads will work: what a block of rows becomes depends on nothing but the block.

#include <algorithm>
#include <deque>
#include <random>
#include <string>
#include <vector>

#include <rotconv/spec.hpp>

#include "catch.hpp"
#include "operations/operations.hpp"
#include "stream/rows/row_transformer.hpp"

using namespace rotconv;
using namespace rotconv::stream;

namespace {

Options options_of(const char* from, const char* to, double tolerance = 1e-3) {
    const Spec spec = std::get<Spec>(parse_spec(from));
    const Conversion conversion(spec, std::get<Spec>(parse_spec(to)), {.tolerance = tolerance});
    const auto operation = operations::convert(conversion, false);
    return {.input = {.numbers = operation->input}, .operation = operation};
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

std::string all_of(const Output& output) {
    std::string text = fmt::to_string(output.bytes);
    for (const Event& event : output.events) {
        if (const auto* error = std::get_if<RowError>(&event)) {
            text += fmt::format("{} {} {}\n", error->place.line, static_cast<int>(error->what), error->text);
        } else {
            const auto& diagnostic = std::get<Diagnostic>(event);
            text += fmt::format("{} {}\n", diagnostic.place.line, name_of(diagnostic.kind));
        }
    }
    return text;
}

/// What the text becomes in pieces of up to so many lines, each by one of the transformers.
std::string transformed(const Options& options, const Layout& layout, std::string_view text, std::size_t most_lines,
                        std::size_t transformers = 1) {
    std::deque<RowTransformer> all;
    for (std::size_t i = 0; i < transformers; ++i) {
        all.emplace_back(options, layout);
    }
    std::mt19937_64 engine(most_lines);
    Output output;
    for (std::size_t line = 1; !text.empty();) {
        std::size_t end = 0;
        std::size_t lines = 0;
        for (const std::size_t wanted = 1 + engine() % most_lines; lines < wanted && end < text.size(); ++lines) {
            end = text.find('\n', end) + 1;
        }
        all[engine() % transformers].transform(text.substr(0, end), line, output);
        text.remove_prefix(end);
        line += lines;
    }
    all.front().finish(output);
    return all_of(output);
}

Layout layout_of(const std::vector<std::size_t>& positions, std::size_t kept) {
    Layout layout;
    layout.delimiter = Delimiter::character(',');
    layout.select(positions, 4, kept);
    return layout;
}

} // namespace

// Catches state that leaks from one block into the next.
TEST_CASE("a stream cut at any line becomes the same") {
    Options options = options_of("quat", "rotvec", 1e9);
    options.on_error = OnError::nan;
    options.input.columns = std::get<ColumnList>(ColumnList::parse("2-5", 4));
    options.diagnostic_columns = true;
    const std::string text = rows(1500);
    const Layout layout = layout_of(options.input.columns.positions(), 0);
    const std::string whole = transformed(options, layout, text, 1);
    for (const std::size_t lines : {3U, 40U, 300U, 2000U}) {
        CHECK(transformed(options, layout, text, lines, 2) == whole);
    }
}

// Catches rows that are held back for those after them, and get lost, doubled or out of order.
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
    for (int i = 0; i < 400; ++i) {
        text += "# many comments\n";
    }
    text += "2000,0,0,1\n";
    const auto all = [&](std::size_t most_lines) {
        const auto operation = operations::propagate(propagation); // which remembers rows
        return transformed({.input = {.numbers = operation->input}, .operation = operation, .on_error = OnError::nan},
                           layout_of({}, 1), text, most_lines);
    };
    const std::string by_row = all(1);
    CHECK(std::ranges::count(by_row, '\n') > 1901);
    CHECK(all(300) == by_row);
    CHECK(all(100000) == by_row);
}

// Catches rows after an error that are written all the same.
TEST_CASE("an error under stop ends the block") {
    Layout layout;
    layout.select({}, 4, 0);
    const Options options = options_of("quat", "quat");
    RowTransformer transformer(options, layout);
    Output output;
    transformer.transform("1 0 0 0\n1 0 0\n0 1 0 0\n", 10, output);
    CHECK(output.stopped);
    CHECK(fmt::to_string(output.bytes) == "1 0 0 0\n");
    REQUIRE(output.events.size() == 1);
    CHECK(std::get<RowError>(output.events[0]).place.line == 11);
}
