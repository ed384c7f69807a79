#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/sampling.hpp>

#include "../stream/number_text.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t largest_count = 1'000'000'000'000'000;

/// The indices of rows: as doubles or, where kinds are given, as text after the kind of each row.
class RowIndices final : public stream::Source {
public:
    RowIndices(std::size_t rows, std::vector<SampleKind> kinds, std::string_view header)
        : rows_(rows), kinds_(std::move(kinds)), made_(header) {}

    std::ptrdiff_t read(std::span<char> to) override {
        for (; next_ < rows_ && made_.size() < to.size(); ++next_) {
            if (kinds_.empty()) {
                const auto index = static_cast<double>(next_);
                made_.append(reinterpret_cast<const char*>(&index), sizeof index); // NOLINT(*-reinterpret-cast)
            } else {
                made_.append(name_of(kinds_[next_ % kinds_.size()])).append(",");
                made_.append(fmt::format_int(next_).c_str()).append("\n");
            }
        }
        const std::size_t size = made_.copy(to.data(), to.size());
        made_.erase(0, size);
        return static_cast<std::ptrdiff_t>(size);
    }

private:
    std::size_t rows_;
    std::size_t next_ = 0;
    std::vector<SampleKind> kinds_;
    std::string made_; ///< and not yet read
};

struct SampleOptions final : RowOptions {
    SampleOptions() {
        degrees.about = "All angles are in degrees";
        header.about = "no (default), or add: print one";
        add("What", {&to, &kind, &rows, &seed, &noise, &degrees});
        add("Output", {&output, &header, &kinds_column, &format, &precision, &decimals});
        add("More", {&threads});
    }

    [[nodiscard]] Command command() const override {
        if (!values.empty()) {
            throw Usage("sample reads no VALUEs: {}", quoted(values[0]));
        }
        const Spec spec = spec_of(to);
        const std::size_t count = count_of(rows, largest_count, 1, 1000);
        const SampleSettings samples{
            kinds_of(spec.name), count_of(seed, largest_count, 0),
            number_of(noise, 5e-4, "number from 0 to 0.5", [](double most) { return most >= 0.0 && most <= 0.5; })};
        const bool has_header =
            one_of<bool>(fmt::format("mode of {}", header.name()), header, {{"no", false}, {"add", true}});
        const stream::RowNumbers numbers{.names = {"index"}};
        RowsCommand made =
            rows_command(numbers, operations::sample(spec, samples), messages::subject_of(spec, any_defect));
        const stream::Format written = made.options.format;
        const bool is_json = written == stream::Format::json;
        const bool has_kinds = kinds_column.given();
        if (has_kinds && !is_json && written != stream::Format::csv) {
            throw Usage("{} can be combined with {} csv and json only", kinds_column.name(), format.name());
        }
        stream::InputOptions& in = made.options.input = {.numbers = numbers};
        in.delimiter = stream::Delimiter::character(',');
        const bool reads_header = has_kinds && (has_header || is_json); // from which JSON has its keys
        using stream::HeaderMode;
        in.header = reads_header ? HeaderMode::yes : has_header && !has_kinds ? HeaderMode::add : HeaderMode::no;
        if (has_kinds) {
            in.columns = std::get<stream::ColumnList>(stream::ColumnList::parse("2", 1));
        } else {
            in.width = 1;
        }
        made.source = std::make_shared<RowIndices>(count, has_kinds ? samples.kinds : std::vector<SampleKind>(),
                                                   reads_header ? "kind,index\n" : "");
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
        for (const std::string_view word : items_of(kind.text())) {
            kinds.push_back(one_of(fmt::format("kind of rows of {}", representation(name).text), word, legal));
            if (std::ranges::count(kinds, kinds.back()) > 1) {
                throw Usage("{} has {} twice", kind.name(), quoted(word));
            }
        }
        return kinds;
    }

    Option kind{"--kind", "KIND", "Kinds, with commas between, that take turns (default: the first six)"};
    Option rows{"--rows", "N", "Rows to write (default 1000)"};
    Option seed{"--seed", "S", "Other rows for another whole number (default 0)"};
    Option noise{"--noise", "E", "The most by which numbers of noise are off, to 0.5 (default 5e-4)"};
    Option kinds_column{"--kinds-column", "", "Write the kind of each row in front, as the column kind"};
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
