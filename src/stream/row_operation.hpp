#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/rates.hpp>

#include "../methods/method_conversion.hpp"

namespace rotconv::stream {

/// Rows that have their numbers, in the order of the stream.
struct NumberRows {
    std::span<const double> numbers;    ///< of all of them, row by row
    std::span<const std::size_t> lines; ///< where they stand
    bool flush = false;                 ///< all are to be answered, as at the end
    /// The texts of the numbers that are kept, row by row; empty where rows are doubles.
    std::span<const std::string_view> kept{};
};

/// What a run makes of the numbers of its rows.
struct RowOperation {
    std::size_t inputs = 0;               ///< numbers that a row gives
    std::vector<std::string> input_names; ///< what they are called
    std::optional<Spec> from{};           ///< what the first of them are, where they are an attitude
    std::size_t kept = 0;                 ///< how many of the first of them also pass to the output as they are
    std::vector<std::string> names;       ///< the columns of the result
    std::optional<Spec> attitude{};       ///< what the result is, where it is an attitude
    bool in_order = false; ///< all rows must come to it in their order; else each copy may answer any of them

    /// Answers rows of `inputs` numbers with names.size() numbers and a report each.
    /// @return how many of the rows are answered, all where none may wait; the others come first in the next call
    std::function<std::size_t(const NumberRows& rows, std::span<double> out, std::span<Report> reports)> run;
};

/// The conversion of attitudes.
[[nodiscard]] RowOperation conversion_operation(const Conversion& conversion);
[[nodiscard]] RowOperation method_operation(const MethodConversion& conversion);

/// The kinematic equation of a representation: the rates' columns have the names of the numbers and `_rate`, or are wx,
/// wy and wz.
[[nodiscard]] RowOperation rates_operation(const Spec& spec, const RateSettings& settings);

/// What a propagation makes of rows t, wx, wy, wz.
struct PropagationRows {
    PropagationSettings settings;
    int time_power = 0;   ///< times are in units of 10^time_power seconds, 0 or less
    bool degrees = false; ///< the angular velocity in degrees a second
    Spec to;              ///< what to make of the attitude
    Settings conversion;
    bool stop_at_error = true; ///< the first error is the end
};
[[nodiscard]] RowOperation propagation_operation(const PropagationRows& rows);

/// Hands the attitude of each row, as a unit quaternion, to `take`. The results are for nobody.
[[nodiscard]] RowOperation reading_operation(const Spec& from, double tolerance,
                                             std::function<void(const Rotation& rotation, std::size_t line)> take);

} // namespace rotconv::stream
