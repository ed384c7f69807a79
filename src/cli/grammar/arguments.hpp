#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/conversion.hpp>

#include "../messages/messages.hpp"
#include "../option_set.hpp"

/// What the arguments of options mean. Each function throws Usage on others.
namespace rotconv::cli {

/// Words and their values.
template <class Value> using Choices = std::vector<std::pair<std::string_view, Value>>;
template <class Value> std::vector<std::string_view> words_of(const Choices<Value>& choices) {
    return mapped(choices, &Choices<Value>::value_type::first);
}
/// The value of a word that is one of the legal ones, which are among the choices.
template <class Value> Value one_of(std::string_view what, const Option& option, std::string_view text,
                                    const Choices<Value>& choices, const std::vector<std::string_view>& legal) {
    if (std::ranges::count(legal, text) == 0) {
        throw messages::no_such_word(what, option, text, legal);
    }
    return std::ranges::find(choices, text, &Choices<Value>::value_type::first)->second;
}
/// The value of an option's argument; the first of its choices if the option is not given.
/// @param what such as "frame", or "mode of --header"
template <class Value> Value one_of(std::string_view what, const Option& option, const Choices<Value>& choices) {
    return one_of(what, option, option.given() ? option.text() : option.choices.front(), choices, option.choices);
}

/// A number for which `holds`; `must`: what it must be, such as "number from 0 to 1".
[[nodiscard]] double number_of(const Option& option, double default_value, std::string_view must,
                               const std::function<bool(double)>& holds);
/// A number that is not negative.
[[nodiscard]] double amount_of(const Option& option, double default_value, bool infinite);
/// A whole number from `least` to `most`.
[[nodiscard]] std::size_t count_of(const Option& option, std::size_t most, std::size_t least = 1,
                                   std::size_t default_value = 0);
/// Units of time, each with the power of ten of its seconds.
// NOLINTNEXTLINE(cert-err58-cpp): without memory nothing works
inline const Choices<int> time_units{{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}};
/// The power of ten of the seconds in a unit of time; 0 if the option is not given.
[[nodiscard]] int time_power_of(const Option& option);

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
    std::optional<AngleUnitName> unit{}; ///< none: a bare 0

    [[nodiscard]] double in(const AngleUnitName& other) const noexcept;
};
/// @param text the option's argument, or the part of it that is an angle
/// @param degrees a bare number is in degrees; otherwise 0 alone may be bare
[[nodiscard]] GivenAngle given_angle(const Option& option, const std::string& text, bool degrees);
/// The ANGLE of an option in radians, finite.
[[nodiscard]] double angle_of(const Option& option, bool degrees, double default_value);

/// @param degrees angles are in degrees, whatever the SPEC says
[[nodiscard]] Spec spec_of(const Option& option, bool degrees);
/// The SPECs of a list, whose column names differ.
[[nodiscard]] std::vector<Spec> specs_of(const Option& option, bool degrees);
/// Refuses a SPEC whose numbers have no rates.
void require_rates(const Option& option, const Spec& spec);

/// An option's "SPEC: NUMBERS".
struct GivenNumbers {
    Spec spec;
    std::string_view row; ///< the numbers as they are written
    std::vector<double> numbers{};
    std::vector<stream::Note> notes{}; ///< what was chosen although the text does not say it
};
[[nodiscard]] GivenNumbers numbers_of(const Option& option, bool degrees);
/// The attitude of these numbers; the identity if the option is not given.
[[nodiscard]] FixedRotation attitude_of(const Option& option, bool degrees, double tolerance);

/// The changes of axes that the options name; none for one that is not given. Refuses a change of hand on one side
/// alone, which gives no rotation.
[[nodiscard]] std::array<AxesChange, 2> axes_of(const Option& reference_axes, const Option& body_axes);

} // namespace rotconv::cli
