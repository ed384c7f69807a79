#include "first_look.hpp"

#include <algorithm>

#include "../stream/fmt.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t most_kept = std::size_t{64} << 10U;

using Fields = std::vector<std::string_view>;

Fields split(std::string_view line, stream::Delimiter delimiter) {
    Fields fields;
    delimiter.split(line, fields);
    return fields;
}

std::size_t count_numbers(const Fields& fields) {
    return static_cast<std::size_t>(std::ranges::count_if(fields, stream::is_number));
}

bool is_row(const Fields& fields) { return 2 * count_numbers(fields) > fields.size(); }

/// What marks a remark, with the blanks after it.
std::string_view without_mark(std::string_view line) {
    const auto name = line.find_first_not_of("#%/; \t");
    return line.substr(std::min(name, line.size()));
}

/// The name in a shell command, where it needs no quotes.
std::string name_in_command(const std::string& file) {
    const bool is_plain = !file.starts_with('-') && std::ranges::all_of(file, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
               c == '-' || c == '/';
    });
    return file == "-" ? "" : is_plain ? " " + file : " FILE";
}

/// With its commas as points each field is a number.
bool has_decimal_commas(std::string_view line) {
    if (line.find(',') == std::string_view::npos) {
        return false;
    }
    std::string with_points(line);
    std::ranges::replace(with_points, ',', '.');
    const auto fields = split(with_points, stream::Delimiter::of_row(with_points));
    return fields.size() > 1 && 2 * count_numbers(fields) > fields.size();
}

std::string_view text_of_line(std::string_view text, std::size_t line) {
    for (; line > 1 && !text.empty(); --line) {
        static_cast<void>(stream::next_line(text));
    }
    return text.empty() ? text : stream::next_line(text).text;
}

/// A header of another width than the rows after it; empty where it is not so.
std::string advice_on_width(std::string_view beginning, std::size_t line, const FirstLook& look, std::size_t count) {
    std::string_view above; // the line, or that above the row at which reading stopped
    std::size_t number = 0;
    for (std::string_view rest = beginning; !rest.empty() && number < line;) {
        const std::string_view text = stream::next_line(rest).text;
        ++number;
        const bool counts = !stream::is_blank(text) && !stream::is_comment(text);
        if (counts && (number < line || look.line > line)) {
            above = text;
        }
    }
    const auto names = split(above, stream::Delimiter::of_row(above));
    const std::size_t fields = look.fields.size();
    if (above.empty() || look.line > line + 1 || count_numbers(names) > 0 || names.size() == fields) {
        return {};
    }
    const std::string told = fmt::format("the header has {} names and the rows {} fields", names.size(), fields);
    if (fields == count) {
        return told + ": add --header yes";
    }
    return names.size() == count ? told + ": add --header yes --columns LIST" : told;
}

} // namespace

FirstLook look_at(std::string_view beginning) {
    FirstLook look;
    std::string_view before;
    std::size_t number = 0;
    for (std::string_view rest = beginning; !rest.empty();) {
        const std::string_view line = stream::next_line(rest).text;
        ++number;
        if (stream::is_blank(line)) {
            continue;
        }
        const auto delimiter = stream::Delimiter::of_row(line);
        const auto fields = split(line, delimiter);
        if (stream::is_comment(line) || !is_row(fields)) {
            before = line;
            continue;
        }
        look.line = number;
        look.delimiter = delimiter;
        look.fields.assign(fields.begin(), fields.end());
        const auto names = split(without_mark(before), delimiter);
        if (names.size() == fields.size() && count_numbers(names) == 0) {
            std::ranges::transform(names, std::back_inserter(look.names),
                                   [&](auto name) { return std::string(delimiter.text_of(name)); });
        }
        return look;
    }
    return look;
}

std::string beginning_of(const std::string& path) {
    stream::File file(path.c_str(), stream::File::Mode::read);
    std::string text(file.is_open() ? std::min(file.size(), most_kept) : 0, '\0');
    const std::ptrdiff_t count = text.empty() ? 0 : file.read(text);
    text.resize(static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0)));
    return text;
}

std::string advice(std::string_view beginning, std::size_t line, std::size_t count, const std::string& file) {
    const std::string_view text = text_of_line(beginning, line);
    const FirstLook look = look_at(beginning);
    const bool is_first = look.line == 0 || line <= look.line;
    if (text.empty() || !is_first) {
        return {};
    }
    const std::string name = name_in_command(file);
    for (const std::string_view mark : {"//", "%"}) {
        if (text.starts_with(mark)) {
            return fmt::format("lines that begin with {} are left out by grep -v '^{}'{} | rotconv ...", mark, mark,
                               name);
        }
    }
    if (text.starts_with("FMT,")) {
        return fmt::format("of a log keep one kind of rows, as grep '^ATT,'{} | rotconv ... does", name);
    }
    if (has_decimal_commas(text)) {
        const std::string input = name.empty() ? "" : " <" + name;
        return fmt::format("the numbers have decimal commas: tr , .{} | rotconv ... makes them points", input);
    }
    if (beginning.find("\nDATA_START") != std::string_view::npos) {
        return fmt::format(
            "the rows stand between two lines: sed -n '/DATA_START/,/DATA_STOP/{{//!p}}'{} | rotconv ...", name);
    }
    if (const std::string told = advice_on_width(beginning, line, look, count); !told.empty()) {
        return told;
    }
    if (look.line > line) {
        return fmt::format("the first row of numbers is line {}: tail -n +{}{} | rotconv ...", look.line, look.line,
                           name);
    }
    return {};
}

std::ptrdiff_t KeptBeginning::read(std::span<char> to) {
    const std::ptrdiff_t count = source_->read(to);
    if (!has_read_) {
        has_read_ = true;
        text_.assign(to.data(), std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0)), most_kept));
    }
    return count;
}

} // namespace rotconv::cli
