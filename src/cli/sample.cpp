#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/sampling.hpp>

#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

constexpr std::int64_t largest_count = 1'000'000'000'000'000;
constexpr double most_noise = 0.5;

/// The indices of rows: as doubles or, where kinds are given, as text after the kind of each row.
class RowIndices final : public stream::Source {
public:
    RowIndices(std::int64_t rows, std::vector<SampleKind> kinds, std::string_view header)
        : rows_(static_cast<std::uint64_t>(rows)), kinds_(std::move(kinds)) {
        stream::append(made_, header);
    }

    std::ptrdiff_t read(std::span<char> to) override {
        for (; next_ < rows_ && made_.size() < to.size(); ++next_) {
            if (kinds_.empty()) {
                const auto index = static_cast<double>(next_);
                stream::append_bytes(made_, {&index, 1});
            } else {
                fmt::format_to(std::back_inserter(made_), "{},{}\n", name_of(kinds_[next_ % kinds_.size()]), next_);
            }
        }
        const std::size_t size = std::min(made_.size(), to.size());
        std::copy_n(made_.data(), size, to.data());
        std::copy(made_.data() + size, made_.data() + made_.size(), made_.data());
        made_.resize(made_.size() - size);
        return static_cast<std::ptrdiff_t>(size);
    }

private:
    std::uint64_t rows_;
    std::uint64_t next_ = 0;
    std::vector<SampleKind> kinds_;
    stream::Buffer made_; ///< and not yet read
};

class SampleOptions final : public RowOptions {
public:
    SampleOptions() {
        set.begin_group("What");
        set.add("-t,--to", to_, "SPEC", "The representation to write: NAME[:MODIFIER]...");
        set.add("--kind", kinds_, "KIND", "Kinds, with commas between, that take turns (default: the first six)");
        set.add("--rows", rows_, "N", "Rows to write (default 1000)");
        set.add("--seed", seed_, "S", "Other rows for another whole number (default 0)");
        set.add("--noise", noise_, "E", "The most by which numbers of noise are off, to 0.5 (default 5e-4)");
        set.add("-d,--degrees", degrees, "All angles are in degrees");
        add_output();
        set.add("--header", header_, "MODE", "no (default), or add: print one");
        set.add("--kinds-column", kinds_column_, "Write the kind of each row in front, as the column kind");
        add_format();
    }

    [[nodiscard]] Command command(const Operands& operands) const override {
        if (!operands.values.empty()) {
            throw Usage(fmt::format("sample reads no VALUEs: {}", quoted(operands.values[0])));
        }
        const Spec to = spec_of("--to", to_, degrees);
        const std::int64_t rows = count_of("--rows", rows_, largest_count);
        const SampleSettings settings{kinds_of(to.name),
                                      static_cast<std::uint64_t>(count_of("--seed", seed_, largest_count, 0)), noise()};
        const bool has_header = one_of<bool>("mode of --header", header_, {{"no", false}, {"add", true}});
        const stream::RowNumbers numbers{.names = {"index"}};
        RowsCommand command =
            rows_command({}, numbers, operations::sample(to, settings), messages::subject_of(to, any_defect), operands);
        const stream::Format written = command.options.format;
        const bool is_json = written == stream::Format::json;
        if (kinds_column_ && !is_json && written != stream::Format::csv) {
            throw Usage("--kinds-column can be combined with --format csv and json only");
        }
        stream::InputOptions& in = command.options.input = {.numbers = numbers};
        in.delimiter = stream::Delimiter::character(',');
        if (kinds_column_) { // JSON has its keys from a header
            const bool reads_header = has_header || is_json;
            in.columns = std::get<stream::ColumnList>(stream::ColumnList::parse("2", 1));
            in.header = reads_header ? stream::HeaderMode::yes : stream::HeaderMode::no;
            command.source =
                std::make_shared<RowIndices>(rows, settings.kinds, reads_header ? "kind,index\n" : std::string_view());
        } else {
            in.width = 1;
            in.header = has_header ? stream::HeaderMode::add : stream::HeaderMode::no;
            command.source = std::make_shared<RowIndices>(rows, std::vector<SampleKind>(), "");
        }
        return command;
    }

private:
    [[nodiscard]] std::vector<SampleKind> kinds_of(RepresentationId name) const {
        std::vector<SampleKind> kinds = sample_kinds_of(name);
        if (kinds_.empty()) {
            kinds.resize(usual_sample_kinds);
            return kinds;
        }
        std::vector<std::pair<std::string_view, SampleKind>> legal;
        std::ranges::transform(kinds, std::back_inserter(legal),
                               [](auto kind) { return std::pair(name_of(kind), kind); });
        kinds.clear();
        const std::string list = kinds_ + ",";
        for (std::string_view rest = list; !rest.empty(); rest.remove_prefix(rest.find(',') + 1)) {
            const std::string_view word = rest.substr(0, rest.find(','));
            kinds.push_back(one_of(fmt::format("kind of rows of {}", representation(name).text), word, legal));
            if (std::ranges::count(kinds, kinds.back()) > 1) {
                throw Usage(fmt::format("--kind has {} twice", quoted(word)));
            }
        }
        return kinds;
    }

    [[nodiscard]] double noise() const {
        double noise = 0.0;
        if (stream::read_number(noise_, noise) != stream::NumberError::none || !(noise >= 0.0 && noise <= most_noise)) {
            throw Usage(fmt::format("--noise {} must be a number from 0 to {}", quoted(noise_), most_noise));
        }
        return noise;
    }

    std::string to_;
    std::string kinds_;
    std::string rows_ = "1000";
    std::string seed_;
    std::string noise_ = "5e-4";
    std::string header_ = "no";
    bool kinds_column_ = false;
};

} // namespace

std::unique_ptr<CommandOptions> sample_options() { return std::make_unique<SampleOptions>(); }

} // namespace rotconv::cli
