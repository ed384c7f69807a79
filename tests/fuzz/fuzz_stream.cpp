// Any bytes as a stream, under options that the first bytes choose: never a crash, and no row lost. The bytes arrive
// whole and in pieces, and must become the same.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include <rotconv/spec.hpp>

#include "stream/run.hpp"

namespace {

using namespace rotconv;
using namespace rotconv::stream;

class Pieces final : public Source {
public:
    Pieces(std::string_view text, std::size_t piece) : text_(text), piece_(piece) {}
    std::ptrdiff_t read(std::span<char> to) override {
        const std::size_t count = std::min({piece_, to.size(), text_.size()});
        std::copy_n(text_.data(), count, to.data());
        text_.remove_prefix(count);
        return static_cast<std::ptrdiff_t>(count);
    }

private:
    std::string_view text_;
    std::size_t piece_;
};

class Text final : public Sink {
public:
    int write(std::string_view bytes) override {
        text += bytes;
        return 0;
    }
    std::string text;
};

struct Result {
    std::string bytes;
    std::size_t faults = 0;
    bool ended_early = false;
};

Result run_in_pieces(std::string_view text, std::size_t piece, const Options& options) {
    Pieces source(text, piece);
    Text sink;
    Result result;
    const Ending ending = run(source, sink, options, [&result](const Event& event) {
        result.faults += std::holds_alternative<RowFault>(event) ? 1U : 0U;
    });
    result.bytes = std::move(sink.text);
    result.ended_early = ending.stopped || ending.fault.has_value();
    return result;
}

Options options_of(const std::uint8_t* choice) {
    static const char* const froms[] = {"quat",       "dcm",           "6d",    "5d", "rotvec:deg",
                                        "axis-angle", "euler:ZYX:deg", "cayley"};
    static const char* const tos[] = {"dcm:col", "quat:xyzw", "euler:zxz:deg", "rotvec", "axis-angle:passive", "cayley",
                                      "mrp",     "5d"};
    const Spec from = std::get<Spec>(parse_spec(froms[choice[0] % 8]));
    const Settings settings{.tolerance = choice[1] % 2 == 0 ? 1e-3 : std::numeric_limits<double>::infinity(),
                            .lock_margin = 1e-15,
                            .figures = choice[1] / 2 % 2 == 0};
    Options options(Conversion(from, std::get<Spec>(parse_spec(tos[choice[0] / 8 % 8])), settings));
    options.header = static_cast<HeaderMode>(choice[1] / 4 % 4);
    options.format = static_cast<Format>(choice[1] / 16 % 3);
    options.on_error = static_cast<OnError>(choice[2] % 3);
    options.append = choice[2] / 3 % 2 == 0;
    options.diagnostic_columns = settings.figures;
    options.precision = choice[2] / 6 % 18;
    options.describe = [](const Diagnostic&) { return std::string("note"); };
    const std::string list = choice[3] % 3 == 0   ? ""
                             : choice[3] % 3 == 1 ? "2-" + std::to_string(from.size() + 1)
                                                  : "a,3-" + std::to_string(from.size() + 1);
    if (!list.empty()) {
        options.columns = std::get<ColumnList>(ColumnList::parse(list, from.size()));
    }
    if (choice[3] / 3 % 2 == 0) {
        options.delimiter = Delimiter::character(',');
    }
    return options;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 5) {
        return 0;
    }
    Options options = options_of(data);
    const std::string_view text(reinterpret_cast<const char*>(data) + 4, size - 4);
    const Result whole = run_in_pieces(text, text.size(), options);
    const Result pieces = run_in_pieces(text, 1 + data[3] % 16U, options);
    if (whole.bytes != pieces.bytes || whole.faults != pieces.faults || whole.ended_early != pieces.ended_early) {
        std::abort();
    }
    if (options.format == Format::csv && options.on_error == OnError::nan && !whole.ended_early &&
        options.header != HeaderMode::add) {
        // one line out for every line in; one that had no line end gets one
        const auto in = std::count(text.begin(), text.end(), '\n');
        const auto out = std::count(whole.bytes.begin(), whole.bytes.end(), '\n');
        if (out < in || out > in + 1) {
            std::abort();
        }
    }
    return 0;
}
