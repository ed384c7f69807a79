#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <rotconv/sampling.hpp>

#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t largest_count = 1'000'000'000'000'000;

/// The indices of rows, as doubles.
class RowIndices final : public stream::Source {
public:
    explicit RowIndices(std::size_t rows) : end_(rows * sizeof(double)) {}

    std::ptrdiff_t read(std::span<char> to) override {
        const std::span<char> made = to.first(std::min(to.size(), end_ - next_));
        for (char& byte : made) {
            const std::size_t index = next_ / sizeof(double);
            const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(static_cast<double>(index));
            byte = bytes.at(next_++ % sizeof(double));
        }
        return static_cast<std::ptrdiff_t>(made.size());
    }

private:
    std::size_t end_;
    std::size_t next_ = 0; ///< index of a byte
};

struct SampleOptions final : RowOptions {
    SampleOptions() {
        degrees.about = "All angles are in degrees";
        header.about = "no (default), or add: print one";
        header.choices = {"no", "add"};
        kind.choices = {sample_kind_names.begin(), sample_kind_names.end()};
        kind.is_list = true;
        add("What", {&to, &kind, &rows, &seed, &noise, &degrees});
        add("Output", {&output, &header, &format, &precision, &decimals});
        add("More", {&threads});
    }

    [[nodiscard]] Command command() const override {
        if (!values.empty()) {
            const auto rows_alone = values.size() > 1
                                        ? std::vector<Mend>()
                                        : std::vector<Mend>{{{{value_words[0], 1, {"--rows", values[0]}}}}};
            throw Usage("sample reads no VALUEs: {}", quoted(values[0])).with(rows_alone);
        }
        const Spec spec = spec_of(to);
        const std::size_t count = count_of(rows, largest_count, 1, 1000);
        const SampleSettings samples{
            kinds_of(spec.name), count_of(seed, largest_count, 0),
            number_of(noise, 5e-4, "number from 0 to 0.5", [](double most) { return most >= 0.0 && most <= 0.5; })};
        const bool has_header = one_of("mode of --header", header, header_modes) == stream::HeaderMode::add;
        RowsCommand made = rows_command(operations::sample(spec, samples));
        made.options.input = {.numbers = made.options.input.numbers,
                              .delimiter = stream::Delimiter::character(','),
                              .width = 1,
                              .header = has_header ? stream::HeaderMode::add : stream::HeaderMode::no};
        made.source = std::make_shared<RowIndices>(count);
        return made;
    }

private:
    [[nodiscard]] std::vector<SampleKind> kinds_of(RepresentationId name) const {
        std::vector<SampleKind> kinds = sample_kinds_of(name);
        if (!kind.given()) {
            kinds.resize(usual_sample_kinds);
            return kinds;
        }
        const Choices<SampleKind> legal = mapped(kinds, [](SampleKind each) { return std::pair(name_of(each), each); });
        kinds.clear();
        for (const std::string_view word : split(kind.text(), ',')) {
            kinds.push_back(one_of(fmt::format("kind of rows of {}", representation(name).text), kind, word, legal,
                                   words_of(legal)));
            if (std::ranges::count(kinds, kinds.back()) > 1) {
                throw Usage("{} has {} twice", kind.name(), quoted(word));
            }
        }
        return kinds;
    }

    Option kind{"--kind", "KIND", "Kinds, with commas between, that take turns (default: the first six)"};
    Option rows{"--rows", "N", "Rows to write (default 1000)"};
    Option seed{"--seed", "S", "Other rows for another whole number (default 0)"};
    Option noise{"--noise", "E", "Largest error of a number in noise rows, at most 0.5 (default 5e-4)"};
};

} // namespace

CommandEntry sample_command() {
    return {"sample", "Write rows on which conversions often fail, to test other programs",
            "Usage: rotconv sample -t SPEC [OPTION]...\n"
            "\nKinds of rows:\n"
            "  uniform     all attitudes alike\n"
            "  small       angles down to 1e-300\n"
            "  half-turn   near a half-turn, and half-turns (cayley: not those)\n"
            "  lock        near gimbal lock, and locked: of SPEC's sequence, else of all 24\n"
            "  border      two quaternion components of equal size, or the trace of dcm 0\n"
            "  cube        the 24 rotations of the cube\n"
            "On request alone; scaled and noise are to be read with --tolerance inf:\n"
            "  scaled      quat: norms from 1e-150 to 1e150\n"
            "  noise       dcm, 6d, 5d: numbers off by up to --noise\n"
            "  many-turns  euler, rpy, rotvec, axis-angle: angles up to 1e15\n",
            make_options<SampleOptions>, 0};
}

} // namespace rotconv::cli
