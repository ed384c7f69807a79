#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../operations/operations.hpp"
#include "command.hpp"
#include "messages.hpp"

/// The options of commands that go through rows.
namespace rotconv::cli {

// What the arguments of options mean; each function throws Usage on others.

/// The value of a word that is one of the choices.
template <class Value> using Choices = std::vector<std::pair<std::string_view, Value>>;
template <class Value> Value one_of(std::string_view what, std::string_view text, const Choices<Value>& choices) {
    const auto found = std::ranges::find(choices, text, &Choices<Value>::value_type::first);
    if (found == choices.end()) {
        throw Usage(messages::no_such_word(what, text, mapped(choices, &Choices<Value>::value_type::first)));
    }
    return found->second;
}
/// That of an option's argument; the first choice if the option is not given.
template <class Value>
Value one_of(const Given& given, std::string_view option, std::string_view what, const Choices<Value>& choices) {
    return given.has(option) ? one_of(what, given.text(option), choices) : choices.front().second;
}

[[nodiscard]] Spec spec_of(std::string_view option, const std::string& text, bool degrees);
[[nodiscard]] inline Spec spec_of(const Given& given, std::string_view option) {
    return spec_of(option, given.text(option), given.has("--degrees"));
}
/// The SPECs of an option that takes several, with commas between, whose column names differ.
[[nodiscard]] std::vector<Spec> specs_of(const Given& given, std::string_view option);
/// Refuses a SPEC whose numbers have no rates.
void require_rates(std::string_view option, const Spec& spec);
/// An option's "SPEC: NUMBERS".
struct GivenNumbers {
    Spec spec;
    std::string_view row; ///< the numbers as they are written
    std::vector<double> numbers{};
};
[[nodiscard]] GivenNumbers numbers_of(const Given& given, std::string_view option);
/// Their attitude; nothing if the option is not given.
[[nodiscard]] std::optional<FixedRotation> attitude_of(const Given& given, std::string_view option);
/// A number for which `holds`; `must`: what it must be, such as "number from 0 to 1".
[[nodiscard]] double number_of(const Given& given, std::string_view option, double default_value, std::string_view must,
                               const std::function<bool(double)>& holds);
/// A number that is not negative.
[[nodiscard]] double amount_of(const Given& given, std::string_view option, double default_value, bool infinite);
/// A whole number from `least` to `most`.
[[nodiscard]] std::size_t count_of(const Given& given, std::string_view option, std::size_t most, std::size_t least = 1,
                                   std::size_t default_value = 0);
/// A unit of angles.
struct AngleUnitName {
    std::string_view text = "rad";
    double per_radian = 1.0;
};
inline constexpr AngleUnitName in_degrees{"deg", degrees_per_radian};
/// An ANGLE as it is given.
struct GivenAngle {
    std::string text{}; ///< with its unit
    double value = 0.0;
    AngleUnitName unit{};
    bool is_bare = false; ///< it was given without the unit

    [[nodiscard]] double in(const AngleUnitName& other) const noexcept;
};
/// @param text the option's argument, or the part of it that is an angle
[[nodiscard]] GivenAngle given_angle(const Given& given, std::string_view option, const std::string& text);
/// The ANGLE of an option in radians, finite.
[[nodiscard]] double angle_of(const Given& given, std::string_view option, double default_value);
[[nodiscard]] Frame frame_of(const Given& given);
/// The power of ten of the seconds in a unit of time.
[[nodiscard]] int time_power_of(const std::string& text);
[[nodiscard]] double tolerance_of(const Given& given);
[[nodiscard]] stream::OnError on_error_of(const Given& given);
/// With the sensitivity of each row if its columns are shown.
[[nodiscard]] ConversionSettings settings_of(const Given& given);
/// The same with what is done to attitudes before they are written.
[[nodiscard]] ConversionSettings attitude_settings_of(const Given& given);

inline constexpr std::size_t widest_row = 100'000; ///< doubles

// Options that several commands have: where rows come from, how they are read and written, and where the answer goes.

void add_reading(OptionSet& set);
void add_writing(OptionSet& set);
/// Those of the above that a command without input has.
void add_output(OptionSet& set);
void add_format(OptionSet& set);
/// What is done to attitudes before they are written, and which of their numbers are.
void add_attitudes(OptionSet& set);
void add_continuous(OptionSet& set);
void add_lock_margin(OptionSet& set);
/// How a FILE and its REFERENCE are read side by side.
void add_pairing(OptionSet& set);

/// There is a REFERENCE.
[[nodiscard]] inline bool is_paired(const Given& given) { return given.files.size() == 2; }
[[nodiscard]] inline bool is_by_key(const Given& given) { return is_paired(given) && given.has("--key"); }

[[nodiscard]] inline operations::PairedRows paired_rows_of(const Given& given) {
    return {is_paired(given), is_by_key(given), is_paired(given) && given.has("--interpolate")};
}

/// The columns to read of one stream, and the option that names them.
struct SelectedColumns {
    std::string list;
    std::string option = "--columns";
    std::string key{}; ///< a column before them
    std::string time_option = "--time-unit";
};

/// Has the input tell what its header says against how its numbers are read: names and units; in notes.cpp.
/// @param refuses names in another order are an error, unless columns are selected by index
/// @throw Usage if the selected names are in another order
void add_notes(const Given& given, const SelectedColumns& selected, bool refuses, stream::InputOptions& input);

/// The same for options that are "SPEC: NUMBERS".
[[nodiscard]] std::vector<stream::Note> notes_on_options(const Given& given);

/// The columns of FILE: its key, if there is one, and those of one attitude, or of both if there is no REFERENCE.
/// @throw Usage if an option about keys is given without a key
[[nodiscard]] SelectedColumns columns_of_file(const Given& given);

/// The command of an operation that takes those numbers of a row.
/// @throw Usage
[[nodiscard]] RowsCommand rows_command(const Given& given, const SelectedColumns& selected,
                                       const stream::RowNumbers& numbers, operations::Operation operation,
                                       messages::Subject subject);
/// Has the command's rows paired with those of the REFERENCE.
/// @throw Usage
void pair(const Given& given, RowsCommand& command, stream::RowNumbers numbers, messages::Subject subject);

/// @throw Usage if there are VALUEs
void refuse_values(const Given& given, std::string_view command);

} // namespace rotconv::cli
