#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/conversion.hpp>

#include "messages.hpp"
#include "usage.hpp"

/// What the arguments of options mean.
namespace rotconv::cli {

/// The value of a word.
/// @throw Usage where it is none of the choices
template <class Value> Value choose(std::string_view what, std::string_view text,
                                    const std::vector<std::pair<std::string_view, Value>>& choices) {
    std::vector<std::string_view> legal;
    for (const auto& [word, value] : choices) {
        if (word == text) {
            return value;
        }
        legal.push_back(word);
    }
    throw Usage(messages::no_such_word(what, text, legal));
}

[[nodiscard]] Spec spec_of(std::string_view option, const std::string& text, bool degrees);
/// Refuses a SPEC whose numbers have no rates.
void require_rates(std::string_view option, const Spec& spec);
/// The attitude of "SPEC: NUMBERS".
[[nodiscard]] FixedRotation attitude_of(std::string_view option, const std::string& text, bool degrees,
                                        double tolerance);
/// A number that is not negative; `default_value` where the option was not given.
[[nodiscard]] double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite);
/// A whole number from `least` to `most`; 0 where the option was not given.
[[nodiscard]] int count_of(std::string_view option, const std::string& text, int most, int least = 1);
[[nodiscard]] Frame frame_of(const std::string& text);
/// The power of ten of the seconds in a unit of time.
[[nodiscard]] int time_power_of(const std::string& text);

} // namespace rotconv::cli
