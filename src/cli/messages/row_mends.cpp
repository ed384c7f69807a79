#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/spec.hpp>

#include "../../core/projects.hpp"
#include "../../operations/operations.hpp"
#include "../../stream/beginning/header_line.hpp"
#include "../../stream/bytes/file.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/value_text.hpp"
#include "../grammar/values.hpp"
#include "answers.hpp"
#include "labelled_lines.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

/// A line in fields, and what it may be.
struct Row : stream::HeaderLine {
    Row(const stream::Line& line_, const stream::InputOptions& input)
        : HeaderLine(line_, input.delimiter.value_or(stream::Delimiter::of_row(line_.text))),
          is_row(input.is_row(line_.text)),
          has_numbers(is_row && 2 * std::ranges::count_if(fields, stream::is_number) > std::ranges::ssize(fields)) {}
    /// As of a header, which may stand behind the mark of a comment.
    [[nodiscard]] std::vector<std::string> header_names() const { return is_row ? names() : without_mark().names(); }
    bool is_row;      ///< neither blank nor a comment
    bool has_numbers; ///< it is a row, and more than half of its fields are numbers
};

std::string replaced(std::string text, char from, char to) {
    std::ranges::replace(text, from, to);
    return text;
}

/// A shell filter, which reads stdin, and its effect on a text.
struct Filter {
    std::string_view command;
    std::string (*of)(const std::string& text);
};
constexpr auto filters = std::to_array<Filter>({
    {"tr , .",
     [](const std::string& text) {
         const bool has_point = text.find('.', text.find('\n')) != std::string::npos; // below a header
         return has_point ? text : replaced(text, ',', '.');
     }},
    {R"(tr , '\t')", // between tabs
     [](const std::string& text) { return text.find('\t') == std::string::npos ? text : replaced(text, ',', '\t'); }},
    {"tr -d '\"'",
     [](const std::string& text) {
         std::string made = text;
         std::erase(made, '"');
         return made;
     }},
    {"sed -E 's/^ *-( +[[]?|[[])//; s/]//g'", // a list of YAML
     [](const std::string& text) {
         bool is_list = true;
         const std::string made = filtered_lines(text, [&is_list](std::size_t, const std::string& line) {
             const std::size_t mark = std::min(line.find_first_not_of(' '), line.size());
             const std::size_t begin = std::min(line.find_first_not_of(' ', mark + 1), line.size());
             const bool is_bracket = line.compare(begin, 1, "[") == 0;
             is_list = is_list && line.compare(mark, 1, "-") == 0 && (begin > mark + 1 || is_bracket);
             std::string own = line.substr(begin + (is_bracket ? 1 : 0));
             std::erase(own, ']');
             return own;
         });
         return is_list ? made : text;
     }},
    {"sed -E 's/[*][0-9A-F]{2}\\r?$//'", // the check sum of NMEA
     [](const std::string& text) {
         return filtered_lines(text, [](std::size_t, const std::string& line) {
             const std::size_t at = line.size() - std::min<std::size_t>(line.size(), 3);
             const bool has_sum = line.size() > 3 && line[at] == '*' &&
                                  line.find_first_not_of("0123456789ABCDEF", at + 1) == std::string::npos;
             return has_sum ? line.substr(0, at) : line;
         });
     }},
});

using Places = std::vector<std::size_t>;

std::optional<double> number_in(std::string_view field) {
    double number = 0.0;
    return stream::read_number(field, number) == stream::NumberError::none ? std::optional(number) : std::nullopt;
}

/// Whether a name differs from the one before only in a number, which is the next: sigma[0] and sigma[1].
bool follows(const std::string& before, const std::string& name) {
    constexpr std::string_view digits = "0123456789";
    const std::size_t end = before.find_last_of(digits) + 1;
    const std::size_t begin = end > 0 ? before.find_last_not_of(digits, end - 1) + 1 : 0;
    const bool has_index = end > begin && end - begin < 3;
    return has_index && name == fmt::format("{}{}{}", before.substr(0, begin),
                                            std::stoi(before.substr(begin, end - begin)) + 1, before.substr(end));
}

/// Names of which some stand twice, each with a suffix that those between two repetitions share: those of two bodies,
/// or of a rotation and a position.
std::vector<std::string> told_apart(std::vector<std::string> names) {
    if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) {
        return names;
    }
    std::set<std::string> run; // since a name came again
    std::size_t runs = 0;
    for (std::string& name : names) {
        if (!run.insert(name).second) {
            run = {name};
            ++runs;
        }
        name += name.empty() ? "" : fmt::format("\x01{}", runs);
    }
    return names;
}

/// A header, and where in it the names of a SPEC are.
struct Header {
    std::vector<std::string> names;
    KnownNames known;
    bool is_row = true; ///< otherwise each name has a line

    [[nodiscard]] std::string list() const {
        return list_of_columns(known.places, is_row ? names : std::vector<std::string>());
    }
};
/// The last of rows that has them, perhaps behind the mark of a comment.
/// @param sought a Spec or a Part
std::optional<Header> header_among(std::span<const Row> rows, const auto& sought) {
    for (std::size_t i = rows.size(); i-- > 0;) {
        const auto names = rows[i].header_names();
        if (const auto known = find_names(sought, names)) {
            return Header{names, *known};
        }
    }
    return std::nullopt;
}

std::vector<Row> rows_of(std::string_view text, const stream::InputOptions& input) {
    std::vector<Row> rows;
    while (!text.empty()) {
        rows.emplace_back(stream::next_line(text), input);
    }
    return rows;
}

/// The beginning of a stream with a row that cannot be read, and how it may be read.
class UnreadRows {
public:
    UnreadRows(const RowsCommand& command, std::string_view text, std::size_t line, bool is_guess)
        : command_(&command), is_guess_(is_guess), input_(command.options.input), spec_(input_.numbers.attitude),
          count_(input_.numbers.names.size()), at_(line - 1), text_(text), rows_(rows_of(text, input_)) {}

    [[nodiscard]] MendGroups mends(bool has_answers) {
        if (at_ >= rows_.size()) {
            return {};
        }
        if (offer_given_names() || offer_sets()) {
            return std::move(mends_);
        }
        const auto above = header_above(at_);
        const auto has_digit = [](std::string_view field) {
            return field.find_first_of("0123456789") != std::string_view::npos;
        };
        if (above && above->names.size() == rows_[at_].fields.size() && !has_answers &&
            std::ranges::none_of(above->known.of(rows_[at_].names()), has_digit)) {
            return {}; // a row of its header whose numbers are missing: what passes over both would lose names
        }
        const auto first = has_answers ? std::ranges::find_if(std::as_const(rows_), &Row::has_numbers) : first_row();
        offer_named_kinds();
        if (first != rows_.end()) {
            offer_every_second(static_cast<std::size_t>(first - rows_.begin()));
        }
        if (has_answers && first != rows_.end()) { // a row among others is what it is
            offer_kind_of_row(*first);
            offer_rows_before();
            return std::move(mends_);
        }
        if (first != rows_.end() && !offer_columns(static_cast<std::size_t>(first - rows_.begin()))) {
            offer_wider_rows(static_cast<std::size_t>(first - rows_.begin()));
            return std::move(mends_);
        }
        if (command_->line->has("--differences")) { // of attitudes alone
            offer({{{Edit::at_end}, 0, {"--differences"}}});
        }
        const std::string_view line = rows_[at_].line.text;
        if (line.find('\t') != std::string_view::npos && line.find(' ') != std::string_view::npos) {
            offer({setting("--delimiter", "blank")});
        }
        const auto mark = line.substr(0, line.find_first_not_of("/%!*;|"));
        offer({setting("--comment", mark.empty() ? "COMMENT" : std::string(mark))});
        offer_joined_lines();
        if (!is_guess_) {
            offer_kinds();
        }
        offer_named_lines();
        offer_labelled_lines();
        offer_text("", std::string(text_));
        offer_last_block(first);
        offer_one_attitude();
        return std::move(mends_);
    }

    /// The columns that a header names, for a row whose numbers are no attitude.
    [[nodiscard]] MendGroups mends_by_names() {
        if (const auto above = at_ < rows_.size() ? header_above(at_) : std::nullopt) {
            offer({setting("--columns", above->list())});
        }
        return std::move(mends_);
    }

private:
    /// Of an option that all commands have which read rows, or --from where these are attitudes.
    [[nodiscard]] Edit setting(std::string_view option, const std::string& argument) const {
        return OptionSet::setting(*command_->line->find(option), argument);
    }
    void offer(const std::vector<Edit>& edits, const std::string& pipe = {}, std::string text = {},
               std::string_view others = {}) {
        mends_.push_back({pipe.empty() ? Mend{edits} : command_->line->piped({edits}, pipe, std::move(text), others)});
    }
    [[nodiscard]] std::size_t place_of(const Row& row) const {
        return static_cast<std::size_t>(row.line.text.data() - text_.data());
    }

    /// Whether a row is an attitude and nothing else.
    [[nodiscard]] bool is_alone() const { return spec_ && spec_->size() == count_; }
    [[nodiscard]] const std::string& from() const { return command_->line->find("--from")->text(); }

    /// The first with numbers that others of its width follow, or else the first.
    [[nodiscard]] std::vector<Row>::const_iterator first_row() const {
        const auto follows = [](const Row& row, const Row& next) {
            return row.has_numbers && next.has_numbers && row.fields.size() == next.fields.size();
        };
        const auto first = std::ranges::adjacent_find(rows_, follows);
        return first == rows_.end() ? std::ranges::find_if(rows_, &Row::has_numbers) : first;
    }
    [[nodiscard]] std::optional<Header> header_above(std::size_t row) const {
        const auto parts = parts_of(input_.numbers);
        const auto part = std::ranges::find_if(parts, [](const Part& each) { return each.attitude.has_value(); });
        if (part == parts.end()) {
            return std::nullopt;
        }
        const auto above = std::span(rows_).first(row);
        const std::size_t size = rows_[row].fields.size();
        std::vector<std::string> names; // of STAR files, a line each: _rlnAngleRot #3
        for (const Row& line : above.last(std::min(size, row))) {
            const bool is_name = line.fields.size() == 2 && line.fields[0].starts_with('_') &&
                                 line.fields[1] == fmt::format("#{}", names.size() + 1);
            names.emplace_back(is_name ? line.fields[0] : "");
        }
        const auto known = names.size() == size ? find_names(*part, names) : std::nullopt;
        return known ? Header{names, *known, false} : header_among(above, *part);
    }
    /// Those offered last are as good as each other.
    void join_groups(std::size_t first) {
        for (; mends_.size() > first + 1; mends_.pop_back()) {
            mends_[first].insert(mends_[first].begin() + 1, mends_.back().begin(), mends_.back().end());
        }
    }

    /// Offers the columns whose names without units are those that are selected. @return whether there are such
    bool offer_given_names() {
        const auto first = first_row();
        const auto items = input_.columns.has_names() ? split(command_->line->find("--columns")->text(), ',')
                                                      : std::vector<std::string_view>();
        for (auto row = first; row != rows_.begin() && first != rows_.end() && !items.empty();) {
            --row;
            const auto names = row->header_names();
            const auto own = mapped(names, [](const std::string& each) { return name_and_unit(each).first; });
            std::vector<std::size_t> places;
            for (const std::string_view item : items) {
                const auto place = std::ranges::find(own, lower(item));
                if (std::ranges::count(own, lower(item)) == 1) {
                    places.push_back(static_cast<std::size_t>(place - own.begin()));
                }
            }
            if (names.size() != first->fields.size() || places.size() != items.size()) {
                continue;
            }
            const auto known = spec_ ? find_names(*spec_, mapped(items, lower)) : std::nullopt;
            if (known && known->decides) { // each number is read by its name
                places = mapped(known->places, [&places](std::size_t each) { return places[each]; });
            }
            if (!is_guess_ || (known && known->decides)) {
                offer(
                    {setting("--columns", list_of_columns(places, row->is_row ? names : std::vector<std::string>()))});
            }
            return true;
        }
        return false;
    }

    /// Offers the two sets of columns that a header names, at the line at which reading stopped or just above.
    /// @return whether there are several
    bool offer_sets() {
        constexpr std::size_t most_above = 3;
        for (std::size_t i = at_ + 1; i-- > at_ - std::min(at_, most_above);) {
            const auto names = rows_[i].has_numbers ? std::vector<std::string>() : rows_[i].names();
            const auto sets = sets_of_row(parts_of(input_.numbers), told_apart(names), "").rows;
            if (sets.size() < 2 || !input_.columns.empty()) { // offer_columns() takes a single one
                continue;
            }
            const std::size_t before = mends_.size();
            for (const auto& set : sets.size() == 2 ? sets : std::vector<Places>()) {
                offer({setting("--columns", list_of_columns(set, names))});
            }
            join_groups(before);
            return true;
        }
        return false;
    }
    /// Offers columns: by the names above the row; the only numbers among its fields; those that are an attitude, or
    /// may be one. False if the names are those of other columns than the row has.
    bool offer_columns(std::size_t row) {
        const auto& fields = rows_[row].fields;
        const auto of_project = spec_ ? columns_of_project(*spec_, fields.size()).positions : Places();
        if (!of_project.empty() && has_time() && of_project.front() > 0) {
            if (const auto columns = selecting(row, of_project)) {
                offer(*columns);
            }
            return true;
        }
        if (const auto above = is_alone() ? header_above(row) : std::nullopt) {
            const bool is_from_one = above->known.of(above->names)[0].find('1') != std::string::npos;
            offer_in_both_orders({setting("--columns", above->list())}, above->known.decides || !is_from_one);
            return above->names.size() == fields.size();
        }
        if (const std::string numbers = numbers_among(fields); !numbers.empty()) {
            offer({setting("--columns", numbers)});
        } else {
            offer_choices(row);
        }
        return true;
    }
    /// Whether each attitude has a time before it, and nothing else.
    [[nodiscard]] bool has_time() const {
        return are_rates_ || (spec_ && input_.numbers.kept == 1 && count_ == spec_->size() + 1);
    }
    /// Columns of attitudes, behind their times where these are wanted: in a column of that name, or the first one if
    /// it has no other name or no numbers.
    [[nodiscard]] std::optional<std::vector<Edit>> selecting(std::size_t row, Places places) const {
        const auto names = names_above(row);
        const auto time = std::ranges::find_if(names, is_name_of_time);
        if (has_time() && time == names.end() && !names.empty() && number_in(rows_[row].fields[0])) {
            return std::nullopt;
        }
        if (has_time()) {
            places.insert(places.begin(), time == names.end() ? 0 : static_cast<std::size_t>(time - names.begin()));
        }
        std::vector<Edit> edits{setting("--columns", list_of_columns(places))};
        if (are_rates_) {
            edits.push_back({{Edit::at_end}, 0, {"--differences"}});
        }
        return edits;
    }
    /// Of a header as wide as the row, at most a line of units above it.
    [[nodiscard]] std::vector<std::string> names_above(std::size_t row) const {
        for (std::size_t i = row; i-- > 0 && i + 3 > row;) {
            auto names = rows_[i].header_names();
            if (!rows_[i].has_numbers && names.size() == rows_[row].fields.size() &&
                !std::ranges::all_of(names, is_unit)) {
                return names;
            }
        }
        return {};
    }
    /// Offers every second line, if rows alternate with other ones, as in COLMAP's images.txt.
    void offer_every_second(std::size_t first) {
        std::string made;
        for (std::size_t i = first; i < rows_.size(); ++i) {
            const bool is_like_first = rows_[i].has_numbers && rows_[i].fields.size() == rows_[first].fields.size();
            const bool is_first_of_two = (i - first) % 2 == 0;
            if (is_like_first != is_first_of_two) {
                return;
            }
            made += is_first_of_two ? std::string(rows_[i].line.text) + "\n" : "";
        }
        if (rows_.size() > first + 2) {
            const std::string pipe = fmt::format("sed -n '{},${{p;n;}}'", first + 1);
            const auto above = header_above(first);
            if (above && above->names.size() == rows_[first].fields.size()) {
                offer({setting("--columns", list_of_columns(above->known.places))}, pipe, made);
            }
            offer_text(pipe, made);
        }
    }
    /// Offers columns, of a quaternion whose order nothing says with either.
    void offer_in_both_orders(const std::vector<Edit>& columns, bool is_known, const std::string& pipe = {},
                              const std::string& text = {}) {
        const std::size_t before = mends_.size();
        offer(columns, pipe, text);
        if (has_open_order(*spec_) && !is_known) {
            auto in_other_order = columns;
            in_other_order.push_back(setting("--from", "quat:xyzw"));
            offer(in_other_order, pipe, text);
            join_groups(before);
        }
    }
    /// Offers columns of a row that may be an attitude. A matrix, perhaps of 3x4 or 4x4, and a quaternion prove
    /// themselves, but for the order of the latter, which only a header just above them tells. Of other numbers only
    /// names and a time say which they are.
    void offer_choices(std::size_t row, const std::string& pipe = {}, const std::string& text = {}) {
        const std::size_t fields = rows_[row].fields.size();
        const std::size_t size = spec_ ? spec_->size() : 0;
        const bool may_choose = (is_alone() || (has_time() && fields > size + 1)) && !input_.columns.has_names();
        const bool is_matrix = may_choose && spec_->name == RepresentationId::dcm;
        if (is_matrix && !has_time()) {
            offer({setting("--columns", "1-3,5-7,9-11")}, pipe, text);
        }
        if (may_choose && !is_matrix && spec_->name != RepresentationId::quat) {
            const Places likely = is_guess_ || !pipe.empty() ? Places() : likely_places(row);
            if (const auto columns = selecting(row, likely); columns && !likely.empty()) {
                offer(*columns);
            }
            return;
        }
        const auto names = row > 0 ? rows_[row - 1].names() : std::vector<std::string>();
        const auto above = may_choose ? header_above(row) : std::nullopt;
        constexpr std::size_t most_places = 20; // each is tried
        auto begins = may_choose ? rotation_places(rows_[row].fields, *spec_) : Places();
        begins.resize(std::min(begins.size(), most_places));
        if (!begins.empty() && begins[0] == 0 && begins_with_time(row)) { // no component, if others may be
            std::rotate(begins.begin(), begins.begin() + 1, begins.end());
        }
        for (const std::size_t i : begins) {
            const auto named = above                    ? std::optional(above->known)
                               : names.size() == fields ? find_names(*spec_, std::span(names).subspan(i, size))
                                                        : std::nullopt;
            const bool is_known = named && named->decides; // in their order from here on
            const std::size_t first = is_known && above ? std::ranges::min(named->places) : 0;
            Places places(size);
            std::iota(places.begin(), places.end(), i);
            for (std::size_t n = 0; n < size && is_known; ++n) {
                places[n] = i + named->places[n] - first;
            }
            if (const auto columns = selecting(row, places)) {
                offer_in_both_orders(*columns, is_known, pipe, text);
            }
        }
    }
    /// Whether the first field is less than that of the next row as wide.
    [[nodiscard]] bool begins_with_time(std::size_t row) const {
        const auto& fields = rows_[row].fields;
        const auto is_like_it = [&](const Row& each) {
            return each.has_numbers && each.fields.size() == fields.size();
        };
        const auto later = std::span(rows_).subspan(row + 1);
        const auto next = std::ranges::find_if(later, is_like_it);
        const auto first = number_in(fields[0]);
        return next != later.end() && first && first < number_in(next->fields[0]);
    }
    /// The only columns that names say to be the numbers, if not in their words: of one stem with indices one after the
    /// other, of six the last; or phi, theta and psi about x, y and z. Otherwise those behind a time.
    [[nodiscard]] Places likely_places(std::size_t row) const {
        const std::size_t size = spec_->size();
        const auto names = mapped(names_above(row), [](const auto& name) { return name_and_unit(name).first; });
        const auto places_from = [size](std::size_t first) {
            Places places(size);
            std::iota(places.begin(), places.end(), first);
            return places;
        };
        std::vector<Places> found;
        for (std::size_t i = 0, end = 1; i < names.size(); i = end++) {
            while (end < names.size() && follows(names[end - 1], names[end])) {
                ++end;
            }
            if (end - i == size || (end - i == 6 && size == 3)) {
                found.push_back(places_from(end - size));
            }
        }
        Places of_axes;
        for (std::size_t i = 0; i < 3 && representation(spec_->name).has_gimbal_lock; ++i) {
            const auto* const word =
                std::array{"phi", "theta", "psi"}.at(static_cast<std::size_t>(spec_->sequence.axis(i)));
            const auto has_word = [&](const std::string& name) {
                return std::ranges::count(parts_of_label(name), word) > 0;
            };
            const auto name = std::ranges::find_if(names, has_word);
            if (std::ranges::count_if(names, has_word) == 1 && !spec_->sequence.proper()) {
                of_axes.push_back(static_cast<std::size_t>(name - names.begin()));
            }
        }
        if (of_axes.size() == 3) {
            found.push_back(of_axes);
        }
        const bool is_behind_time = rows_[row].fields.size() == size + 1 && begins_with_time(row);
        return found.size() == 1 ? found[0] : found.empty() && is_behind_time ? places_from(1) : Places();
    }
    /// Offers rows that have more fields than their header: dates with blanks.
    void offer_wider_rows(std::size_t first) {
        const auto above = header_above(first);
        const auto& fields = rows_[first].fields;
        if ((input_.columns.empty() || input_.columns.has_names()) && above && above->names.size() < fields.size() &&
            rotation_places(fields, *spec_).size() == 1) {
            offer_choices(first, fmt::format("tail -n +{}", first + 1),
                          std::string(text_.substr(place_of(rows_[first]))));
        }
    }
    /// The fields that are numbers, as a LIST, if others are not and they are as many as are wanted; empty if not.
    [[nodiscard]] std::string numbers_among(const std::vector<std::string_view>& fields) const {
        std::vector<std::size_t> columns;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (stream::is_number(fields[i])) {
                columns.push_back(i + 1);
            }
        }
        const bool has_brackets = std::ranges::any_of(
            fields, [](std::string_view field) { return field.find_first_of("[](){}") != std::string_view::npos; });
        const bool has_labels = !columns.empty() && fields[0].ends_with(':') && // each line is another thing
                                std::ranges::any_of(rows_, [&fields](const Row& each) {
                                    return each.has_numbers && each.fields[0] != fields[0];
                                });
        const bool is_range = columns.size() > 2 && columns.back() - columns.front() + 1 == columns.size();
        return columns.size() != count_ || columns.size() == fields.size() || has_labels || has_brackets ? ""
               : is_range ? fmt::format("{}-{}", columns.front(), columns.back())
                          : joined(columns);
    }

    /// Offers a command that makes the text, and those that change characters in it, also with the only numbers of its
    /// first row; without a command only the latter.
    void offer_text(const std::string& pipe, const std::string& text) {
        const auto offer_made = [this](const std::string& command, const std::string& made, const std::string& others) {
            offer({}, command, made, others);
            std::string_view rest = made;
            const std::string columns = rest.empty() ? "" : numbers_among(Row(stream::next_line(rest), input_).fields);
            if (!columns.empty()) {
                offer({setting("--columns", columns)}, command, made, others);
            }
        };
        if (!pipe.empty()) {
            offer_made(pipe, text, "");
        }
        for (const Filter& filter : filters) {
            const std::string command(filter.command);
            if (const std::string made = filter.of(text); made != text && made != text + "\n") {
                offer_made(pipe.empty() ? command : pipe, made, pipe.empty() ? "" : " | " + command);
                mends_.back()[0].keeps_lines = pipe.empty();
            }
        }
    }

    /// Offers the last of several blocks of numbers, if it is like no other.
    void offer_last_block(std::vector<Row>::const_iterator first) {
        std::size_t i = rows_.size();
        while (i > 0 && !rows_[i - 1].has_numbers) {
            --i;
        }
        while (i > 0 && rows_[i - 1].has_numbers) {
            --i;
        }
        const auto block = rows_.cbegin() + static_cast<std::ptrdiff_t>(i);
        const auto is_alike = [&](const Row& row) {
            return row.has_numbers && row.fields.size() == block->fields.size();
        };
        if (i >= std::max<std::size_t>(at_, 1) && block != rows_.cend() &&
            (first >= block || std::none_of(rows_.cbegin(), block, is_alike))) {
            offer_block(i - 1, i); // with its header
            offer_block(i, i);
        }
    }
    /// Offers the lines from one on, up to one after the first numbers that has none: numbers may also be described by
    /// rows.
    void offer_block(std::size_t begin, std::size_t first) {
        const auto rows = std::span(rows_).subspan(first);
        const auto end = std::ranges::find_if_not(rows, &Row::has_numbers);
        const bool is_rest = std::none_of(end, rows.end(), [](const Row& each) { return each.is_row; });
        const std::size_t size = is_rest ? std::string_view::npos : place_of(*end) - place_of(rows_[begin]);
        const std::string pipe =
            is_rest ? fmt::format("tail -n +{}", begin + 1)
                    : fmt::format("sed -n {},{}p", begin + 1, first + static_cast<std::size_t>(end - rows.begin()));
        const std::string text(text_.substr(place_of(rows_[begin]), size));
        offer_text(pipe, text);
        if (begin == first) {
            offer_choices(first, pipe, text);
        }
    }

    /// Offers rows of which each is several lines: matrices, perhaps of 3x4 or 4x4; and one of single numbers.
    void offer_joined_lines() {
        const auto lines = filtered(rows_, [](const Row& row) { return !row.line.text.empty(); });
        const std::size_t width = lines.empty() ? 0 : lines[0].fields.size();
        const auto is_like_first = [&](const Row& row) { return row.has_numbers && row.fields.size() == width; };
        const bool is_matrix = spec_ && spec_->name == RepresentationId::dcm && width > 1;
        const bool is_whole = width == 4 && lines.size() > 3 && lines[3].fields.size() == 4 &&
                              number_in(lines[3].fields[0]) == 0.0 && number_in(lines[3].fields[1]) == 0.0;
        const std::size_t height = !is_matrix ? count_ : is_whole ? 4 : 3;
        if (!spec_ || !(is_matrix ? width == 3 || width == 4 : width == 1 && lines.size() == height) ||
            lines.size() % height != 0 || !std::ranges::all_of(lines, is_like_first) ||
            text_.find('\r') != std::string_view::npos) {
            return;
        }
        const bool is_comma = lines[0].delimiter.text() == ',';
        std::string made;
        std::string command = is_comma ? "paste -d ," : "paste -d ' '";
        for (std::size_t i = 0; i < lines.size(); ++i) {
            command += i < height ? " -" : "";
            made += std::string(lines[i].line.text) + (i % height + 1 == height ? '\n' : is_comma ? ',' : ' ');
        }
        const auto columns = width == 4 ? std::vector{setting("--columns", "1-3,5-7,9-11")} : std::vector<Edit>();
        offer(columns, "grep .", made, " | " + command);
    }

    /// The words with which rows begin.
    [[nodiscard]] std::vector<std::string> kinds_of_rows() const {
        std::vector<std::string> kinds;
        for (const Row& row : rows_) {
            const std::string_view name = row.has_numbers ? row.fields[0] : "";
            const bool is_word = !name.empty() && lower(name.substr(0, 1)) >= "a" && lower(name.substr(0, 1)) <= "z";
            const bool is_plain_word = is_word && name.find_first_of("*.[]^$\\") == std::string_view::npos;
            if (kinds.size() < most_known_kinds && is_plain_word && !stream::is_number(name) &&
                std::ranges::count(kinds, name) == 0) {
                kinds.emplace_back(name);
            }
        }
        return kinds;
    }
    /// Offers rows that begin with the name of their kind, for each of several kinds.
    void offer_kinds() {
        auto kinds = kinds_;
        std::erase_if(kinds, [this](const std::string& kind) { // of a single row
            return std::ranges::count_if(rows_, [&kind](const Row& row) { return row.line.text.starts_with(kind); }) <
                   2;
        });
        for (const std::string& kind :
             kinds.size() < 2 || kinds.size() > most_kinds ? std::vector<std::string>() : kinds) {
            offer_kind(kind, {});
        }
    }
    /// Offers the rows that begin with a word, and others with these columns.
    void offer_kind(const std::string& kind, const std::vector<Edit>& edits) {
        std::string rows;
        char end = ' ';
        for (const Row& row : rows_) {
            if (!row.fields.empty() && row.fields[0] == kind) {
                end = row.delimiter.text();
                rows += std::string(row.line.text) + "\n";
            }
        }
        const std::string pipe = "grep " + in_shell("^" + kind + (end == ' ' ? "[[:blank:]]" : std::string(1, end)));
        edits.empty() ? offer_text(pipe, rows) : offer(edits, pipe, rows);
    }
    /// Offers the rows that begin with the same word as one, if no others are as wide.
    void offer_kind_of_row(const Row& row) {
        const auto is_of_kind = [&row](const Row& each) { return each.fields[0] == row.fields[0]; };
        const auto is_as_wide = [&row](const Row& each) {
            return each.has_numbers && each.fields.size() == row.fields.size();
        };
        if (std::ranges::count(kinds_, row.fields[0]) > 0 && !is_of_kind(rows_[at_]) &&
            std::ranges::count_if(rows_, is_as_wide) > 1 &&
            std::ranges::all_of(rows_, [&](const Row& each) { return !is_as_wide(each) || is_of_kind(each); })) {
            offer_kind(std::string(row.fields[0]), {});
        }
    }
    /// Offers the rows before an end that has no numbers.
    void offer_rows_before() {
        const bool is_end =
            std::none_of(rows_.begin() + static_cast<std::ptrdiff_t>(at_), rows_.end(),
                         [](const Row& row) { return std::ranges::any_of(row.fields, stream::is_number); });
        if (is_end && !is_cut()) {
            offer({}, fmt::format("head -n {}", at_), std::string(text_.substr(0, place_of(rows_[at_]))));
        }
    }
    /// Whether more of the input may follow.
    [[nodiscard]] bool is_cut() const {
        const char* const path = command_->input.c_str();
        return stream::File::is_regular(path) ? stream::File(path, stream::File::Mode::read).size() > text_.size()
                                              : text_.size() > most_first_bytes / 2;
    }
    /// Offers the rows of a kind whose names a row of another one ends with, as FMT of ArduPilot's logs.
    void offer_named_kinds() {
        const auto kinds = spec_ ? kinds_ : std::vector<std::string>();
        for (const Row& row : rows_) {
            const auto names = row.has_numbers || kinds.empty() ? std::vector<std::string>() : row.names();
            const auto kind = std::ranges::find_first_of(kinds, names);
            if (kind == kinds.end() || names[0] == *kind) {
                continue;
            }
            const auto first = std::ranges::find_if(
                rows_, [&kind](const Row& each) { return each.has_numbers && each.fields[0] == *kind; });
            const std::size_t count = std::min(first->fields.size() - 1, names.size());
            const auto last = names.end() - static_cast<std::ptrdiff_t>(count);
            const auto sets = sets_of_row(parts_of(input_.numbers), {last, names.end()}, "").rows;
            if (sets.size() == 1 && count + 1 == first->fields.size()) {
                const auto columns = mapped(sets[0], [](std::size_t place) { return place + 2; });
                offer_kind(*kind, {setting("--columns", joined(columns))});
            }
        }
    }
    /// Offers numbers that stand one below the other, each behind its name, perhaps with a name above them all.
    void offer_named_lines() {
        if (is_alone()) {
            const std::size_t before = mends_.size();
            const auto lines = mapped(rows_, [](const Row& row) { return row.line.text; });
            const bool is_unix = text_.find('\r') == std::string_view::npos;
            for (const auto& each : named_lines(is_unix ? lines : std::vector<std::string_view>(), *spec_, is_cut())) {
                offer({setting("--columns", each.columns)}, each.command, each.text, each.others);
            }
            join_groups(before);
        }
    }

    void offer_labelled_lines() {
        const auto lines = mapped(rows_, [](const Row& row) { return row.line.text; });
        const auto is_named = [this](std::string_view line) {
            return lower(line).find(representation(spec_->name).text) != std::string::npos;
        };
        if (!is_alone()) {
            return;
        }
        const bool by_labels = is_guess_ && std::ranges::none_of(lines, is_named);
        const auto found = labelled_lines(lines, input_.numbers, from(), by_labels);
        if (found && (!is_guess_ || found->is_named || is_named(found->line))) {
            std::vector<Edit> edits{setting("--columns", found->columns)};
            if (found->is_ragged) {
                edits.push_back({{Edit::at_end}, 0, {"--ragged"}});
            }
            offer(edits, found->command, found->text, found->others);
        }
    }

    /// Offers the lines that alone are an attitude, as VALUEs are, if no other line may be one or says what they are;
    /// of matrices with names, the first two.
    void offer_one_attitude() {
        constexpr std::size_t most_lines = 200;
        constexpr std::size_t longest = 16'384;
        const bool is_matrix = spec_ && spec_->name == RepresentationId::dcm; // which proves itself
        if (!is_alone() || rows_.size() > most_lines || text_.size() > longest || (is_guess_ && !is_matrix)) {
            return;
        }
        const std::initializer_list<std::size_t> heights = {5, 4, 3, 1}; // of a matrix and its name, or of any attitude
        struct Found {
            std::size_t first;
            std::size_t size;
            std::string text;
        };
        std::vector<Found> found;
        const auto has_name = [](const Found& lines) { return lines.size == 5; };
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            std::string text;
            const auto holds = [&](std::size_t height) {
                if ((height > 1 && !is_matrix) || i + height > rows_.size()) {
                    return false;
                }
                const std::string_view last = rows_[i + height - 1].line.text;
                text = {rows_[i].line.text.data(), last.data() + last.size()};
                bool means_other = false;
                const auto values = attitude_in(text, input_.numbers, from(), means_other);
                return values && (is_matrix || !values->has_other_label);
            };
            const auto* const height = std::ranges::find_if(heights, holds);
            if (height != heights.end()) {
                found.push_back({i, *height, text + "\n"});
                i += *height - 1;
            } else if (may_mean_attitude(rows_[i].line.text)) {
                return;
            }
        }
        if (found.size() > 1 && (is_guess_ || !std::ranges::all_of(found, has_name))) {
            return;
        }
        const std::size_t before = mends_.size();
        for (const Found& lines : std::span(found).first(std::min<std::size_t>(found.size(), 2))) {
            offer({},
                  lines.size == 1 ? fmt::format("sed -n {}p", lines.first + 1)
                                  : fmt::format("sed -n {},{}p", lines.first + 1, lines.first + lines.size),
                  lines.text);
        }
        join_groups(before);
    }
    /// Whether a line has the numbers of an attitude, or words that say something of others.
    [[nodiscard]] bool may_mean_attitude(std::string_view line) const {
        std::string words(line);
        std::size_t numbers = 0;
        for (char& c : words) {
            c = is_alphanumeric(c) || c == '.' || c == '-' || c == '_' ? c : ' ';
        }
        const auto is_telling = [&](const std::string& word) {
            numbers += stream::is_number(word) ? 1 : 0;
            const std::string own = lower(word);
            return is_operation(word) || is(vocabulary::aside, own) || own.starts_with("cov") ||
                   own.find("inv") != std::string::npos || own.find("major") != std::string::npos ||
                   (own.size() > 1 && !stream::is_number(word) && messages::is_verb(own));
        };
        return std::ranges::any_of(words_in(words), is_telling) || numbers >= count_;
    }

    static constexpr std::size_t most_kinds = 4;
    static constexpr std::size_t most_known_kinds = 32;

    const RowsCommand* command_;
    bool is_guess_; ///< the SPEC is one
    const stream::InputOptions& input_;
    const std::optional<Spec>& spec_;
    bool are_rates_ = command_->line->missing("--differences") != nullptr; ///< of velocities beside attitudes
    std::size_t count_;                                                    ///< of numbers
    std::size_t at_; ///< index of the line at which reading stopped
    std::string_view text_;
    std::vector<Row> rows_;
    std::vector<std::string> kinds_ = kinds_of_rows();
    MendGroups mends_{};
};

} // namespace

MendGroups row_mends(const RowsCommand& command, std::string_view beginning, std::size_t line, bool is_guess,
                     bool has_answers) {
    const bool is_text = beginning.find('\0') == std::string_view::npos;
    return is_text ? UnreadRows(command, beginning, line, is_guess).mends(has_answers)
                   : numpy_mends(command, beginning);
}

MendGroups name_mends(const RowsCommand& command, std::string_view beginning, std::size_t line) {
    return UnreadRows(command, beginning, line, false).mends_by_names();
}

MendGroups reference_mends(const RowsCommand& command, std::string_view text, std::string_view beginning) {
    const stream::InputOptions& input = command.options.pairing->reference;
    const auto& spec = input.numbers.attitude;
    const Option* const option = command.line->missing("--reference-columns");
    const auto rows = rows_of(beginning, input);
    const auto row = std::ranges::find_if(rows, &Row::has_numbers);
    if (!spec || option == nullptr || row == rows.end()) {
        return {};
    }
    KnownNames found{columns_of_project(*spec, row->fields.size()).positions};
    constexpr std::size_t most_header_bytes = 4096;
    const auto first = rows_of(text.substr(0, text.find('\n', most_header_bytes)), command.options.input);
    const auto end = std::ranges::find_if(first, &Row::has_numbers);
    if (const auto of_file = header_among({first.begin(), end}, *spec);
        found.places.empty() && row == rows.begin() && of_file && of_file->names.size() == row->fields.size()) {
        found = of_file->known; // two files of one kind, of which one has names
    }
    return found.places.empty() ? MendGroups()
                                : MendGroups{{{{OptionSet::setting(*option, list_of_columns(found.places))}}}};
}

} // namespace rotconv::cli
