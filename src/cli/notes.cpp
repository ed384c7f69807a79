#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "../stream/number_text.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

using Kind = stream::Note::Kind;

/// deg or rad, also of a rate, or a unit of time, as headers write it; empty for others.
std::string_view unit_of(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> units{
        {{"deg", " deg degree degrees dps \u00B0 "},
         {"rad", " rad radian radians rps "},
         {"s", " s sec secs second seconds "},
         {"ms", " ms msec millisecond milliseconds "},
         {"us", " us usec \u00B5s \u03BCs microsecond microseconds "},
         {"ns", " ns nsec nsecs nanosecond nanoseconds "}}};
    std::string unit = lower(text);
    std::erase_if(unit, [](char c) { return c == ' ' || c == '\t' || c == '_'; });
    for (const std::string_view per_second : {"", "/sec", "/s", "s^-1", "s-1", "pers", "s"}) {
        const std::string word = ' ' + unit.substr(0, unit.size() - std::min(unit.size(), per_second.size())) + ' ';
        for (const auto& [name, words] : units) {
            const bool fits = per_second.empty() || name == "deg" || name == "rad";
            if (fits && unit.ends_with(per_second) && word.size() > 2 && words.find(word) != std::string_view::npos) {
                return name;
            }
        }
    }
    return {};
}

bool is_angle(std::string_view unit) { return unit == "rad" || unit == "deg"; }

/// The name and the unit that a text of a header holds: "yaw [deg]", "w_x_rad_s".
std::pair<std::string, std::string_view> name_and_unit(const std::string& text) {
    const auto bracket = text.ends_with(']')   ? text.rfind('[')
                         : text.ends_with(')') ? text.rfind('(')
                                               : std::string::npos;
    if (bracket != std::string::npos) {
        return {lower(stream::trimmed(text.substr(0, bracket))),
                unit_of(std::string_view(text).substr(bracket + 1, text.size() - bracket - 2))};
    }
    for (auto at = text.find('_', 1); at != std::string::npos; at = text.find('_', at + 1)) {
        if (const auto unit = unit_of(std::string_view(text).substr(at)); !unit.empty()) {
            return {lower(text.substr(0, at)), unit};
        }
    }
    return {lower(text), {}};
}

/// A number's canonical name: w, q_w and q_RS_w of a quaternion are qw.
std::string own_name(const Spec& spec, const std::string& text) {
    const std::string name = name_and_unit(text).first;
    const auto letter = name.find_last_of("wxyz");
    const std::string stem = name.substr(0, letter);
    const bool is_one = spec.name == RepresentationId::quat && !name.empty() && letter + 1 == name.size() &&
                        (stem.empty() || stem == "q" || (stem.starts_with("q_") && stem.ends_with('_')));
    return is_one ? std::string("q") + name.back() : name;
}

/// The first of a SPEC's numbers that is an angle, as are those after it.
std::size_t first_angle(const Spec& spec) {
    return !representation(spec.name).has_angles() ? spec.size() : spec.name == RepresentationId::axis_angle ? 3 : 0;
}

/// The notes on one stream.
class Notes {
public:
    Notes(const Given& given, std::string_view time_option, bool refuses, const stream::InputOptions& input)
        : degrees_(given.has("--degrees")), time_option_(time_option), refuses_(refuses && input.columns.empty()),
          units_(input.numbers.names.size()) {
        const std::string& time_unit = given.text(given.has(time_option) ? time_option : "--time-unit");
        const auto& names = input.numbers.names;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool is_rate = names[i] == "wx" || names[i] == "wy" || names[i] == "wz";
            const bool is_time = names[i] == "t" || (names[i] == "key" && !time_unit.empty());
            units_[i] = is_rate ? (degrees_ ? "deg" : "rad") : !is_time ? "" : time_unit.empty() ? "s" : time_unit;
        }
        if (input.numbers.attitude) {
            attitudes_.emplace_back(input.numbers.kept, *input.numbers.attitude);
        }
        if (const auto& second = input.numbers.second) {
            attitudes_.emplace_back(names.size() - second->size(), *second);
        }
        for (const auto& [first, spec] : attitudes_) {
            for (std::size_t i = first_angle(spec); i < spec.size(); ++i) {
                units_[first + i] = spec.unit == AngleUnit::degrees ? "deg" : "rad";
            }
        }
    }

    [[nodiscard]] std::vector<std::string> own_names(std::vector<std::string> names) const {
        for (std::string& name : names) {
            name = name_and_unit(name).first;
        }
        for (const auto& [first, spec] : attitudes_) {
            for (std::size_t i = first; i < std::min(first + spec.size(), names.size()); ++i) {
                names[i] = own_name(spec, names[i]);
            }
        }
        return names;
    }

    [[nodiscard]] std::vector<stream::Note> operator()(const stream::Said& said) const {
        std::vector<stream::Note> notes;
        const auto add = [&notes](Kind kind, const std::string& text, bool ends_run = false) {
            if (!text.empty()) {
                notes.push_back({kind, text, ends_run});
            }
        };
        if (!said.comment.empty()) {
            const std::string comment = quoted(said.comment);
            add(Kind::comments,
                fmt::format("there were only comments, such as {}; if these are rows: --comment none", comment));
        }
        for (const auto& [first, spec] : attitudes_) {
            if (!said.names.empty()) {
                add(Kind::order, other_order(spec, std::span(said.names).subspan(first, spec.size())), refuses_);
            }
        }
        for (std::size_t i = 0; i < said.names.size(); ++i) {
            const auto unit = name_and_unit(said.names[i]).second;
            const std::string& own = units_[i];
            if (!unit.empty() && !own.empty() && unit != own && is_angle(unit) == is_angle(own)) {
                add(is_angle(own) ? Kind::unit : Kind::time_unit,
                    fmt::format("the header's {} is in {}, but {}", quoted(said.names[i]), unit, mend(i, unit)));
            }
        }
        return notes;
    }

private:
    [[nodiscard]] std::string other_order(const Spec& spec, std::span<const std::string> names) const {
        const auto own = mapped(names, [&spec](const std::string& name) { return own_name(spec, name); });
        const std::string wrong = wrong_order(spec, {own.begin(), own.end()}, fmt::format("{}", fmt::join(names, ",")));
        return wrong.empty()
                   ? wrong
                   : fmt::format("the header {}{}", wrong, refuses_ ? " (if it is mislabelled, select by index)" : "");
    }

    [[nodiscard]] std::string mend(std::size_t at, std::string_view unit) const {
        if (!is_angle(unit)) {
            return fmt::format("times are read in {}: {} {}", units_[at], time_option_, unit);
        }
        for (const auto& [first, spec] : attitudes_) {
            if (at >= first && at < first + spec.size()) {
                Spec right = spec;
                right.unit = unit == "deg" ? AngleUnit::degrees : AngleUnit::radians;
                return fmt::format("{} reads {}: {}{}", spec.text(),
                                   spec.unit == AngleUnit::degrees ? "degrees" : "radians", right.text(),
                                   degrees_ ? ", without -d" : "");
            }
        }
        return fmt::format("angular velocities are read in {}/s: {} -d", units_[at],
                           unit == "deg" ? "add" : "leave out");
    }

    bool degrees_;                                        ///< angular velocities too
    std::string time_option_;                             ///< that names the unit
    bool refuses_;                                        ///< names in another order
    std::vector<std::string> units_;                      ///< of each number; empty: not one of those in headers
    std::vector<std::pair<std::size_t, Spec>> attitudes_; ///< each with the place of its first number
};

} // namespace

void add_notes(const Given& given, std::string_view time_option, bool refuses, stream::InputOptions& input) {
    const Notes notes(given, time_option, refuses, input);
    input.notes_of = notes;
    input.own_names = [notes](std::vector<std::string> names) { return notes.own_names(std::move(names)); };
}

std::vector<stream::Note> notes_on_options(const Given& given) {
    std::vector<stream::Note> notes;
    for (const std::string_view option : {"--left", "--right", "--initial"}) {
        if (given.has(option)) {
            const GivenNumbers read = numbers_of(given, option);
            if (const double angle = unusual_numbers(read.spec, read.numbers).angle; angle > 0.0) {
                notes.push_back(
                    {Kind::angle, fmt::format("{}: an angle of {:.6g} is read in radians; if it is in degrees: {}",
                                              option, angle, read.spec.in_degrees().text())});
            }
        }
    }
    return notes;
}

} // namespace rotconv::cli
