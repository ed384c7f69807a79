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

std::vector<SampleKind> kinds_of(const std::string& list, RepresentationId name) {
    std::vector<SampleKind> kinds = sample_kinds_of(name);
    if (list.empty()) {
        kinds.resize(usual_sample_kinds);
        return kinds;
    }
    const Choices<SampleKind> legal = mapped(kinds, [](SampleKind kind) { return std::pair(name_of(kind), kind); });
    kinds.clear();
    for (const std::string_view word : items_of(list)) {
        kinds.push_back(one_of(fmt::format("kind of rows of {}", representation(name).text), word, legal));
        if (std::ranges::count(kinds, kinds.back()) > 1) {
            throw Usage("--kind has {} twice", quoted(word));
        }
    }
    return kinds;
}

Command sample(const Given& given) {
    if (!given.values.empty()) {
        throw Usage("sample reads no VALUEs: {}", quoted(given.values[0]));
    }
    const Spec to = spec_of(given, "--to");
    const std::size_t rows = count_of(given, "--rows", largest_count, 1, 1000);
    const SampleSettings settings{kinds_of(given.text("--kind"), to.name), count_of(given, "--seed", largest_count, 0),
                                  number_of(given, "--noise", 5e-4, "number from 0 to 0.5",
                                            [](double noise) { return noise >= 0.0 && noise <= 0.5; })};
    const bool has_header = one_of<bool>(given, "--header", "mode of --header", {{"no", false}, {"add", true}});
    const stream::RowNumbers numbers{.names = {"index"}};
    RowsCommand command =
        rows_command(given, {}, numbers, operations::sample(to, settings), messages::subject_of(to, any_defect));
    const stream::Format written = command.options.format;
    const bool is_json = written == stream::Format::json;
    const bool has_kinds = given.has("--kinds-column");
    if (has_kinds && !is_json && written != stream::Format::csv) {
        throw Usage("--kinds-column can be combined with --format csv and json only");
    }
    stream::InputOptions& in = command.options.input = {.numbers = numbers};
    in.delimiter = stream::Delimiter::character(',');
    const bool reads_header = has_kinds && (has_header || is_json); // from which JSON has its keys
    using stream::HeaderMode;
    in.header = reads_header ? HeaderMode::yes : has_header && !has_kinds ? HeaderMode::add : HeaderMode::no;
    if (has_kinds) {
        in.columns = std::get<stream::ColumnList>(stream::ColumnList::parse("2", 1));
    } else {
        in.width = 1;
    }
    command.source = std::make_shared<RowIndices>(rows, has_kinds ? settings.kinds : std::vector<SampleKind>(),
                                                  reads_header ? "kind,index\n" : "");
    return command;
}

} // namespace

CommandEntry sample_command() {
    OptionSet set;
    set.add("-t,--to", "SPEC", "The representation to write: NAME[:MODIFIER]...");
    set.add("--kind", "KIND", "Kinds, with commas between, that take turns (default: the first six)");
    set.add("--rows", "N", "Rows to write (default 1000)");
    set.add("--seed", "S", "Other rows for another whole number (default 0)");
    set.add("--noise", "E", "The most by which numbers of noise are off, to 0.5 (default 5e-4)");
    set.add_flag("-d,--degrees", "All angles are in degrees");
    add_output(set);
    set.add("--header", "MODE", "no (default), or add: print one");
    set.add_flag("--kinds-column", "Write the kind of each row in front, as the column kind");
    add_format(set);
    return {"sample",
            "Write rows on which conversions often fail, to test other programs",
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
            std::move(set),
            sample,
            0};
}

} // namespace rotconv::cli
