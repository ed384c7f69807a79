#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/spec.hpp>

#include "../operations/operations.hpp"
#include "../stream/file.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"
#include "../stream/preamble.hpp"
#include "../stream/run.hpp"
#include "column_names.hpp"
#include "messages.hpp"
#include "option_set.hpp"
#include "values.hpp"

namespace rotconv::cli::messages {
namespace {

/// A line in fields, and what it may be.
struct Row : stream::HeaderLine {
    Row(const stream::Line& line_, const stream::InputOptions& input)
        : HeaderLine(line_, input.delimiter.value_or(stream::Delimiter::of_row(line_.text))),
          is_row(input.is_row(line_.text)),
          has_numbers(is_row && 2 * std::ranges::count_if(fields, stream::is_number) > std::ranges::ssize(fields)) {}
    bool is_row;      ///< neither blank nor a comment
    bool has_numbers; ///< it is a row, and more than half of its fields are numbers
};

/// Whether the text has rows, and all are read and answered by the operation; without one, their numbers are read.
bool reads(std::string_view text, stream::InputOptions input, const stream::RowOperation* operation = nullptr) {
    const auto nothing = [](const stream::NumberRows& rows, const auto&...) { return rows.lines.size(); };
    if (input.take_count) {
        input.take_count = [](std::size_t fields) { return fields; };
    }
    const stream::Options options{.input = std::move(input),
                                  .operation = operation != nullptr
                                                   ? std::make_shared<stream::RowOperation>(*operation)
                                                   : operations::operation_of(nothing, {}, {"nothing"})};
    stream::TextSource source{std::string(text)};
    const auto result = stream::run(source, nullptr, options, [](const stream::Event&) {});
    return !result.error && !result.stopped && result.answered > 0;
}

/// The option that selects the numbers of a SPEC by their names; empty if the names are not all there.
std::string columns_option(const std::optional<Spec>& spec, const std::vector<std::string>& names) {
    const auto known = spec ? find_names(*spec, names) : std::nullopt;
    return known ? "--columns " + in_shell(joined(known->of(names))) : "";
}

/// What a command of the shell, which reads stdin, makes of a text.
struct Filter {
    std::string_view told;
    std::string_view command;
    char from = '\0'; ///< the character that it replaces
    char to = '\0';   ///< '\0': it takes the character out

    [[nodiscard]] std::string of(std::string_view text) const {
        std::string made(text);
        if (to == '\0') {
            std::erase(made, from);
        } else {
            std::ranges::replace(made, from, to);
        }
        return made;
    }
};
constexpr auto filters = std::to_array<Filter>({
    {"to turn decimal commas into points", "tr , .", ',', '.'},
    {"commas and tabs part the numbers", R"(tr , '\t')", ',', '\t'},
    {"to take numbers out of quotes", "tr -d '\"'", '"'},
});

/// The beginning of a stream with a row that cannot be read, and how it can be read.
class UnreadRows {
public:
    UnreadRows(std::string_view text, const stream::Options& options, const std::string& file)
        : text_(text), input_(options.input),
          operation_(options.operation->in_order || options.pairing || input_.take_count ? nullptr
                                                                                         : options.operation.get()),
          file_(file == "-" ? "" : " " + file_in_shell(file)) {
        while (!text.empty()) {
            rows_.emplace_back(stream::next_line(text), input_);
        }
        first_ = static_cast<std::size_t>(std::ranges::find_if(rows_, &Row::has_numbers) - rows_.begin());
        width_ = first_ < rows_.size() ? rows_[first_].fields.size() : 0;
    }

    /// See messages::advice(). @param at index of the line at which reading stopped
    [[nodiscard]] std::string advice(std::size_t at, bool has_header) {
        if (at >= rows_.size() || reads(text_, input_)) { // what is wrong is not how the numbers stand
            return {};
        }
        for (std::size_t i = at + 1; by_name_ && i < rows_.size(); ++i) {
            if (!rows_[i].is_remark() &&
                std::holds_alternative<std::vector<std::size_t>>(input_.columns.positions(rows_[i].names()))) {
                return fmt::format("line {0} has them: tail -n +{0}{1} | rotconv ...", i + 1, file_);
            }
        }
        if (at > first_ || (has_header && rows_[at].fields.size() == width_)) {
            return {};
        }
        std::string of_header = first_ > at + 1 ? "" : header_advice();
        offer_options(rows_[at].line.text);
        if (found_.empty() && of_header.find(": ") != std::string::npos) {
            return of_header;
        }
        if (first_ == at) {
            offer_kinds();
        }
        for (const Filter& filter : filters) {
            offer(
                filter.of(text_), input_,
                fmt::format("{}: {}{}{} | rotconv ...", filter.told, filter.command, file_.empty() ? "" : " <", file_));
        }
        for (const std::size_t row : {last_block(), first_}) {
            if (row > at && row < rows_.size()) {
                offer_rows(row);
            }
        }
        offer_kinds();
        found_ = found_.empty() && input_.columns.empty() ? print_advice() : found_;
        return found_.empty() ? of_header : found_;
    }

private:
    /// Says of the header right before the first row with numbers what is wrong with it, or which columns it has.
    [[nodiscard]] std::string header_advice() const {
        const auto names = by_name_ || width_ == 0 || first_ == 0 ? std::vector<std::string>()
                                                                  : rows_[first_ - 1].without_mark().names();
        if (names.empty() || std::ranges::any_of(names, stream::is_number)) {
            return {};
        }
        if (names.size() == width_) {
            const std::string option = columns_option(input_.numbers.attitude, names);
            return !input_.columns.empty() || width_ <= count_ ? ""
                   : option.empty()                            ? "the columns are " + numbered(names)
                                                               : "the header has them: " + option;
        }
        stream::InputOptions with_header = input_;
        with_header.header = stream::HeaderMode::yes;
        const bool helps = reads(text_, with_header);
        const bool selects = input_.columns.empty() && names.size() == count_;
        return fmt::format("the header has {} and the rows {}{}{}", counted(names.size(), "name"),
                           counted(width_, "field"), helps || selects ? ": add --header yes" : "",
                           selects && !helps ? " --columns LIST" : "");
    }

    /// The first of the last rows that have one number of fields; none where rows before them have it too.
    [[nodiscard]] std::size_t last_block() const {
        std::size_t first = rows_.size();
        std::size_t width = 0;
        for (; first > 0; --first) {
            const Row& row = rows_[first - 1];
            if (row.is_row && (!row.has_numbers || (width != 0 && row.fields.size() != width))) {
                break;
            }
            width = row.is_row ? row.fields.size() : width;
        }
        const auto has_width = [width](const Row& row) { return row.fields.size() == width; };
        return std::ranges::any_of(std::span(rows_).first(first), has_width) ? rows_.size() : first;
    }

    /// Takes what is told, if it is the first that helps: with it, the text is read so, and answered by the operation.
    void offer(std::string_view text, const stream::InputOptions& input, const std::string& told,
               const stream::RowOperation* operation = nullptr) {
        found_ = found_.empty() && reads(text, input, operation) ? told : found_;
    }

    /// Offers options with which the line at which reading stopped is read, or left out.
    void offer_options(std::string_view line) {
        stream::InputOptions input = input_;
        if (line.find('\t') != std::string_view::npos && line.find(' ') != std::string_view::npos) {
            input.delimiter = stream::Delimiter::blanks();
            offer(text_, input, "tabs and blanks part the numbers: add --delimiter blank");
            input.delimiter = input_.delimiter;
        }
        input.comment = line.substr(0, line.find_first_not_of("/%!*;|"));
        input.comment = input.comment.empty() ? "COMMENT" : input.comment;
        if (line.starts_with(input.comment)) {
            offer(text_, input,
                  fmt::format("lines that begin with {} are not rows: add --comment {}", input.comment,
                              in_shell(input.comment)));
        }
    }

    /// Offers a command that makes the text of the rows from one on: by index, if the columns that are given do not
    /// serve, with a LIST of those that are numbers.
    void offer_text(std::string_view text, std::size_t row, const stream::RowOperation* operation,
                    const std::string& command) {
        if (!by_name_) {
            offer(text, input_, command + " | rotconv ...", operation);
        }
        std::vector<std::size_t> columns;
        for (std::size_t i = 0; i < rows_[row].fields.size() && columns.size() < count_; ++i) {
            if (stream::is_number(rows_[row].fields[i])) {
                columns.push_back(i + 1);
            }
        }
        auto list = stream::ColumnList::parse(joined(columns), count_);
        if ((by_name_ || input_.columns.empty()) && std::holds_alternative<stream::ColumnList>(list)) {
            stream::InputOptions selecting = input_;
            selecting.columns = std::get<stream::ColumnList>(std::move(list));
            offer(text, selecting, command + " | rotconv ... --columns LIST");
        }
    }

    /// Offers rows that begin with the name of their kind, for each of several kinds.
    void offer_kinds() {
        for (std::size_t i = first_; i < rows_.size() && found_.empty(); ++i) {
            const Row& row = rows_[i];
            const std::string_view name = row.has_numbers ? row.fields[0] : "";
            if (name.empty() || !is_alphanumeric(name[0]) || stream::is_number(name)) {
                continue;
            }
            const std::string_view text = row.line.text;
            const std::string kind(text.substr(0, static_cast<std::size_t>(name.end() - text.begin()) + 1));
            const auto is_of_kind = [&kind](const Row& each) { return each.line.text.starts_with(kind); };
            const auto count = std::ranges::count_if(rows_, is_of_kind);
            if (count < 2 || count == std::ranges::count_if(rows_, &Row::has_numbers) ||
                &*std::ranges::find_if(rows_, is_of_kind) != &row) {
                continue; // a name of its own, the only kind, or one that was tried
            }
            std::string rows;
            for (const Row& each : rows_) {
                rows.append(is_of_kind(each) ? each.line.text : "").append(each.line.end);
            }
            offer_text(rows, i, nullptr,
                       fmt::format("to keep only one kind of row: grep {}{}", in_shell("^" + kind), file_));
        }
    }

    /// Offers the rows with numbers from one on, perhaps up to a row without: numbers may also be described by rows.
    void offer_rows(std::size_t row) {
        const auto rows = std::span(rows_).subspan(row);
        const auto end = std::ranges::find_if_not(rows, &Row::has_numbers);
        const bool is_rest = std::none_of(end, rows.end(), [](const Row& each) { return each.is_row; });
        const auto place = [this](const Row& each) {
            return static_cast<std::size_t>(each.line.text.data() - text_.data());
        };
        const std::string_view text =
            text_.substr(place(rows[0]), is_rest ? std::string_view::npos : place(*end) - place(rows[0]));
        const std::string command = fmt::format(
            "the first row of numbers is line {}: {}{}", row + 1,
            is_rest ? fmt::format("tail -n +{}", row + 1)
                    : fmt::format("sed -n {},{}p", row + 1, row + static_cast<std::size_t>(end - rows.begin())),
            file_);
        offer_text(text, row, operation_, command);
        for (const Filter& filter : filters) {
            offer_text(filter.of(text), row, operation_, fmt::format("{} | {}", command, filter.command));
        }
    }

    /// Advice on numbers as programs print them for people.
    [[nodiscard]] std::string print_advice() const {
        if (std::ranges::any_of(rows_, [](const Row& row) { return row.line.text == "---"; })) {
            return "messages that are parted by --- are printed as rows by ros2 topic echo --csv";
        }
        Values values;
        try {
            values = values_of({std::string(text_)}, std::nullopt, input_.numbers, {}, false);
        } catch (const cli::Usage&) {
            return {};
        }
        std::vector<std::string_view> fields;
        static_cast<void>(values.delimiter.split(values.row, fields));
        return fields.size() == count_ && std::ranges::all_of(fields, stream::is_number)
                   ? "numbers as programs print them can be given as one VALUE, in quotes" +
                         (file_.empty() ? "" : fmt::format(": rotconv ... \"$(cat{})\"", file_))
                   : "";
    }

    std::string_view text_;
    const stream::InputOptions& input_;
    const stream::RowOperation* operation_; ///< what rows must pass; null if it remembers rows: they are only read
    std::string file_;                      ///< in a command
    bool by_name_ = input_.columns.has_names();
    std::size_t count_ = input_.numbers.names.size();
    std::vector<Row> rows_;
    std::size_t first_ = 0; ///< the first row with numbers
    std::size_t width_ = 0; ///< its fields; 0: there is none
    std::string found_;     ///< the first advice that helps
};

} // namespace

std::string advice(std::string_view beginning, std::size_t line, bool has_header, const stream::Options& options,
                   const std::string& file) {
    if (beginning.find('\0') != std::string_view::npos) {
        return "the input is not text: rows of numbers are read, as NumPy's savetxt or ros2 topic echo --csv write "
               "them";
    }
    if (beginning.size() >= most_first_bytes) { // its last line is cut
        beginning = beginning.substr(0, beginning.rfind('\n') + 1);
    }
    return UnreadRows(beginning, options, file).advice(line - 1, has_header);
}

std::string contents_advice(const std::string& path) {
    if (!stream::File::is_regular(path.c_str())) {
        return {};
    }
    stream::File file(path.c_str(), stream::File::Mode::read);
    std::string text(file.is_open() ? std::min(file.size(), most_first_bytes) : 0, '\0');
    const std::ptrdiff_t count = text.empty() ? 0 : file.read(text);
    if (count <= 0) {
        return {};
    }
    text.resize(static_cast<std::size_t>(count));
    constexpr std::array<const char*, 3> specs{"quat", "dcm", "rpy"};
    stream::InputOptions input;
    input.columns_of = [&specs](const std::vector<std::string>& names) {
        return stream::ChosenColumns{.are_known = std::ranges::any_of(specs, [&names](const char* spec) {
                                         return find_names(std::get<Spec>(parse_spec(spec)), names).has_value();
                                     })};
    };
    stream::Preamble preamble(input);
    stream::IoBlock block;
    block.text = stream::without_byte_order_mark(text);
    stream::Output nowhere;
    preamble.read(block, true, nowhere);
    const Row row(preamble.has_row() ? stream::next_line(block.text) : stream::Line(), input);
    if (!row.has_numbers) {
        return fmt::format("; {} does not begin with a row of numbers", quoted(path));
    }
    const std::vector<std::string>& header = preamble.layout().names;
    const auto names = header.empty() ? std::vector<std::string>(row.fields.begin(), row.fields.end()) : header;
    std::string told =
        fmt::format("; {} has {}: {}", quoted(path), counted(row.fields.size(), "column"), numbered(names));
    for (const char* spec : specs) {
        if (const std::string option = columns_option(std::get<Spec>(parse_spec(spec)), names); !option.empty()) {
            return fmt::format("{}; perhaps -f {} {}", told, spec, option);
        }
    }
    return told;
}

} // namespace rotconv::cli::messages
