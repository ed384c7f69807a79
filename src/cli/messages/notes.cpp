#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "../../core/projects.hpp"
#include "../grammar/column_names.hpp"
#include "../row_options.hpp"
#include "answers.hpp"

namespace rotconv::cli {
namespace {

using Kind = stream::Note::Kind;

bool is_angle(std::string_view unit) { return unit == "rad" || unit == "deg"; }

/// The notes on one stream.
class Notes {
public:
    Notes(const RowOptions& options, const Option& time_option, bool names_decide, std::string key,
          const stream::InputOptions& input)
        : key_(std::move(key)), degrees_(options.degrees.given()), time_option_(time_option.name()),
          time_unit_((time_option.given() ? time_option : options.time_unit).text()),
          are_selected_(!input.columns.empty()),
          is_named_(input.numbers.names.size(), names_decide && input.columns.empty()),
          parts_(parts_of(input.numbers)) {
        const auto selected = input.columns.names();
        for (std::size_t i = 0; names_decide && i < selected.size(); ++i) {
            is_named_[i] = !selected[i].empty();
        }
    }

    [[nodiscard]] std::vector<std::size_t> order_of(const std::vector<std::string>& names) const {
        auto named = names;
        for (std::size_t i = 0; i < names.size(); ++i) {
            named[i] = is_named_[i] ? names[i] : "";
        }
        return names_of_row(parts_, named).places;
    }

    [[nodiscard]] stream::ChosenColumns columns_of(const std::vector<std::string>& names) const {
        const ColumnSets sets = sets_of_row(parts_, names, key_);
        stream::ChosenColumns chosen{.are_known = sets.are_known};
        const std::size_t first = key_.empty() ? 0 : 1; // without the key, which has an option of its own
        constexpr std::size_t most = 4;
        const std::size_t count = sets.rows.size();
        const auto options = mapped(std::span(sets.rows).first(std::min(most, count)), [&](const auto& row) {
            return "--columns " + in_shell(list_of_columns(std::span(row).subspan(first), names));
        });
        if (count == 1) {
            chosen.positions = sets.rows[0];
            chosen.text = fmt::format("the columns are taken by their names: {}", options[0]);
        } else if (count > 1) {
            chosen.text = fmt::format("the header names {} sets of columns: {}{}", count, joined(options, " or "),
                                      count > most ? " ..." : "");
        }
        return chosen;
    }

    [[nodiscard]] std::vector<stream::Note> on(const stream::HeaderFacts& said) const {
        std::vector<stream::Note> notes;
        if (!said.comment.empty()) {
            notes.push_back(
                {Kind::comments, fmt::format("there were only comments, such as {}; if these are rows: --comment none",
                                             quoted(said.comment))});
        }
        if (said.passed > 0) {
            const bool is_one = said.passed == 1;
            return {{Kind::passed, fmt::format("{} before the first row {}: {}", counted(said.passed, "line"),
                                               is_one ? "is not a row and passes through unchanged"
                                                      : "are not rows and pass through unchanged; the first is",
                                               quoted(said.comment))}};
        }
        if (said.only_header) {
            notes.push_back({Kind::only_header, "the only row was taken for the header; if it is data: --header no"});
        }
        if (said.names.empty()) {
            return notes;
        }
        const auto places = order_of(said.names);
        const auto names = mapped(places, [&said](std::size_t place) { return said.names[place]; });
        const auto sets = names_of_row(parts_, names).sets;
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            if (const std::string told = order_told(parts_[k], sets[k], names, places, said.header); !told.empty()) {
                notes.push_back({Kind::order, "the header" + told});
            }
        }
        for (const Part& part : parts_) {
            for (std::size_t i = 0; i < part.names.size(); ++i) {
                const std::string& name = names[part.begin + i];
                const std::size_t column = places[part.begin + i];
                const bool has_own = column < said.units.size();
                const auto unit = has_own ? unit_of(said.units[column]) : name_and_unit(name).second;
                if (const std::string told = other_unit(part, i, unit); !told.empty()) {
                    stream::Note note{
                        Kind::unit, fmt::format("the header's {} is in {}, but {}", quoted(name), unit, told), {}, {}};
                    if (!is_angle(unit)) {
                        note.kind = Kind::time_unit;
                        note.words = {time_option_, std::string(unit)};
                    }
                    notes.push_back(std::move(note));
                }
            }
        }
        return notes;
    }

private:
    /// How numbers are read that are not those, or not in the order, that their names or the SPEC say.
    /// @param places of the numbers among the columns as they are selected
    [[nodiscard]] std::string order_told(const Part& part, const std::optional<KnownNames>& set,
                                         const std::vector<std::string>& names, const std::vector<std::size_t>& places,
                                         std::span<const std::string> header) const {
        const std::string own = joined(part.of(names));
        const auto begin = static_cast<std::ptrdiff_t>(part.begin);
        const auto end = begin + static_cast<std::ptrdiff_t>(part.names.size());
        if (set && !set->decides) {
            return fmt::format("'s {} do not say which numbers of {} they are, and are read as they stand: as {}", own,
                               part.attitude->text(), joined(part.names));
        }
        if (set && !std::ranges::equal(set->of(names), part.of(names))) {
            return fmt::format("'s {} are read as they stand: as {}", own, joined(set->of(names)));
        }
        if (set && part.attitude && part.attitude->has_given_order &&
            !std::is_sorted(places.begin() + begin, places.begin() + end)) {
            return fmt::format("'s names are not in the order of {}: each number is read by its name",
                               part.attitude->text());
        }
        const bool may_be_others = !set && part.attitude && !are_selected_ &&
                                   !representation(part.attitude->name).has_gimbal_lock; // angles have many names
        const auto are_names_of = [&](const char* spec) {
            const auto other = find_names(*messages::spec_of(spec), part.of(names));
            return other && other->decides;
        };
        if (may_be_others && (are_names_of("quat") || are_names_of("rpy") || are_names_of("dcm"))) {
            return fmt::format("'s {} are read as they stand: as {}", own, joined(part.names));
        }
        const bool is_by_index =
            std::find(is_named_.begin() + begin, is_named_.begin() + end, false) < is_named_.begin() + end;
        const auto others = !set && part.attitude && is_by_index ? find_names(part, header) : std::nullopt;
        if (!others || !others->decides) {
            return "";
        }
        return fmt::format(" has {} at {}, but {} are read", joined(others->of(header)),
                           list_of_columns(others->places), own);
    }

    /// What is to be done about the unit that a header gives to one of the part's numbers, if it is another than that
    /// in which the number is read.
    [[nodiscard]] std::string other_unit(const Part& part, std::size_t at, std::string_view unit) const {
        const bool degrees = unit == "deg";
        if (part.attitude) {
            const Representation& read = representation(part.attitude->name);
            Spec right = *part.attitude;
            right.unit = degrees ? AngleUnit::degrees : AngleUnit::radians;
            return is_angle(unit) && read.has_angles() && at >= read.first_angle && right.unit != part.attitude->unit
                       ? fmt::format("{} reads {}: {}{}", part.attitude->text(), degrees ? "radians" : "degrees",
                                     right.text(), degrees_ ? ", without -d" : "")
                       : "";
        }
        if (part.names.front() == "wx") {
            return is_angle(unit) && degrees != degrees_
                       ? fmt::format("angular velocities are read in {}/s: {} -d", degrees_ ? "deg" : "rad",
                                     degrees ? "add" : "leave out")
                       : "";
        }
        const std::string& name = part.names.front();
        const bool is_time = name == "t" || (name == "key" && !time_unit_.empty());
        const std::string own = time_unit_.empty() ? "s" : time_unit_;
        return is_time && !unit.empty() && !is_angle(unit) && unit != own
                   ? fmt::format("times are read in {}: {} {}", own, time_option_, unit)
                   : "";
    }

    std::string key_;            ///< its column, as it is given
    bool degrees_;               ///< angular velocities too
    std::string time_option_;    ///< that names the unit
    std::string time_unit_;      ///< empty: keys have none, and times are in seconds
    bool are_selected_;          ///< by --columns
    std::vector<bool> is_named_; ///< of each number: its column is not selected by index
    std::vector<Part> parts_;    ///< of a row
};

/// The first of the texts that is a change of axes, as an option; nothing where the axes stay as they are.
std::string first_change(std::string_view option,
                         std::initializer_list<std::pair<std::string_view, std::string_view>> pairs) {
    for (const auto& [from, to] : pairs) {
        const std::string change = fmt::format("{}:{}", from, to);
        if (std::holds_alternative<AxesChange>(parse_axes(change))) {
            return from == to ? "" : fmt::format(" {} {}", option, change);
        }
    }
    return "";
}

} // namespace

std::string change_of_axes(const Project& from, const Project& to) {
    // Reference axes that no option can take to others, such as right, up, forward to east, north, up, are those of a
    // body.
    return first_change("--reference-axes",
                        {{from.reference, to.reference}, {from.reference, to.body}, {from.body, to.reference}}) +
           first_change("--body-axes", {{from.body, to.body}});
}

void read_names(const RowOptions& options, const Option& time_option, bool names_decide, const std::string& key,
                stream::InputOptions& input) {
    const auto notes = std::make_shared<const Notes>(options, time_option, names_decide, key, input);
    input.is_unit = is_unit;
    input.order_of = [notes](const std::vector<std::string>& names) { return notes->order_of(names); };
    if (names_decide) {
        // A header is asked about several times, and may be long.
        input.columns_of = [notes,
                            last = std::make_shared<std::pair<std::vector<std::string>, stream::ChosenColumns>>()](
                               const std::vector<std::string>& names) {
            if (names != last->first) {
                *last = {names, notes->columns_of(names)};
            }
            return last->second;
        };
    }
    input.notes_of = [notes](const stream::HeaderFacts& said) { return notes->on(said); };
}

std::optional<stream::Note> note_on_axes(const OptionSet& options) {
    const auto is_given = [&options](const char* name) { return options.given(name) != nullptr; };
    if (!is_given("--from") || !is_given("--to") ||
        std::ranges::any_of(std::array{"--reference-axes", "--body-axes", "--left", "--right"}, is_given)) {
        return std::nullopt;
    }
    const auto change = axes_of_specs(options.find("--from")->text(), options.find("--to")->text());
    return change.empty() ? std::nullopt
                          : std::optional(stream::Note{Kind::axes,
                                                       "--from and --to have different axes, which no SPEC changes: " +
                                                           joined(change, " "),
                                                       {},
                                                       {}});
}

std::vector<stream::Note> notes_on_options(const RowOptions& options) {
    std::vector<stream::Note> notes;
    if (const auto note = note_on_axes(options)) {
        notes.push_back(*note);
    }
    for (const Option* option : {&options.left, &options.right, &options.initial}) {
        if (option->given()) {
            const GivenNumbers read = numbers_of(*option, options.degrees.given());
            std::ranges::copy(read.notes, std::back_inserter(notes));
            if (const double angle = unusual_numbers(read.spec, read.numbers).angle; angle > 0.0) {
                notes.push_back(
                    {Kind::angle, fmt::format("{}: an angle of {:.6g} is read in radians; if it is in degrees: {}",
                                              option->name(), angle, read.spec.in_degrees().text())});
            }
        }
    }
    return notes;
}

} // namespace rotconv::cli
