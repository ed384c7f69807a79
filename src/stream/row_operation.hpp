#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/comparison.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/identification.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/rates.hpp>

#include "../methods/method_conversion.hpp"

namespace rotconv::stream {

/// Rows that have their numbers, in the order of the stream.
struct NumberRows {
    std::span<const double> numbers;    ///< of all of them, row by row
    std::span<const std::size_t> lines; ///< where they stand
    /// The texts of the numbers that are kept, row by row; empty where rows are doubles.
    std::span<const std::string_view> kept{};
};

/// What a run makes of the numbers of its rows.
struct RowOperation {
    std::size_t inputs = 0;               ///< numbers that a row gives
    std::vector<std::string> input_names; ///< what they are called
    std::optional<Spec> from{};           ///< what the first of them are, where they are an attitude
    std::size_t kept = 0;           ///< how many of the first of them, such as a time or a key, also pass as they are
    std::vector<std::string> names; ///< the columns of the result
    std::optional<Spec> attitude{}; ///< what the result is, where it is an attitude
    /// Where each row gets several answers, a line each: their names, for the column `method` before the last number.
    /// RowReport::row is then the index of the answer among those of all rows.
    std::vector<std::string> answers{};
    /// Told once, before the first row, which fields hold the numbers, from 0; none where a row is its numbers.
    std::function<void(const std::vector<std::size_t>& positions)> selected{};
    bool in_order = false; ///< all rows must come to it in their order; else each copy may answer any of them

    [[nodiscard]] std::size_t answers_of_row() const noexcept { return answers.empty() ? 1 : answers.size(); }

    /// Answers rows of `inputs` numbers with names.size() numbers each, or so many for each answer. `reports` become
    /// those of the rows of which there is something to tell, in their order.
    std::function<void(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports)> run;
    /// Where an answer depends on the rows after it, to be called in the place of `run`: answers as many of the first
    /// rows as it can, or all with `flush`. The others come first in the next call.
    /// @return how many are answered
    std::function<std::size_t(const NumberRows& rows, bool flush, std::span<double> out,
                              std::vector<RowReport>& reports)>
        run_ahead{};
    /// What is done to the results of `run` and `run_ahead`, of all rows in the order of the stream: copies share what
    /// it remembers. Null: nothing.
    std::function<void(std::span<double> results, std::span<const RowReport> reports)> choose{};
};

/// The conversion of attitudes.
[[nodiscard]] RowOperation conversion_operation(const Conversion& conversion);
[[nodiscard]] RowOperation method_operation(const MethodConversion& conversion);
/// The answers of all its methods, each with its angle to the attitude.
[[nodiscard]] RowOperation all_methods_operation(const MethodConversion& conversion);

/// The same operation, whose result follows the motion; see ContinuousNumbers.
[[nodiscard]] RowOperation continuous(RowOperation operation);

/// What the columns of an angular velocity are called.
[[nodiscard]] std::vector<std::string> velocity_names(bool degrees);

/// The kinematic equation of a representation: the rates' columns have the names of the numbers and `_rate`, or are
/// velocity_names(). `sensitivity`: a report of every row.
[[nodiscard]] RowOperation rates_operation(const Spec& spec, const RateSettings& settings, bool sensitivity);

/// What a propagation makes of rows t, wx, wy, wz.
struct PropagationRows {
    PropagationSettings settings;
    int time_power = 0;   ///< times are in units of 10^time_power seconds, 0 or less
    bool degrees = false; ///< the angular velocity in degrees a second
    Spec to;              ///< what to make of the attitude
    ConversionSettings conversion;
    bool stop_at_error = true; ///< the first error is the end
};
[[nodiscard]] RowOperation propagation_operation(const PropagationRows& rows);

/// What a comparison makes of rows that hold both attitudes.
struct ComparisonRows {
    bool paired = false;    ///< the second attitude comes from a reference...
    bool by_key = false;    ///< ...and each of the two has its key before it
    bool with_line = false; ///< the row's line after the angle, in the place of the relative attitude
};
[[nodiscard]] RowOperation comparison_operation(const Comparison& comparison, const ComparisonRows& rows);
/// What is read of the reference: an attitude, perhaps after its key.
[[nodiscard]] RowOperation reference_operation(const Spec& spec, bool by_key);

/// Hands the attitude of each row, as a unit quaternion, to `take`. The results are for nobody.
[[nodiscard]] RowOperation reading_operation(const Spec& from, double tolerance,
                                             std::function<void(const Rotation& rotation, std::size_t line)> take);

/// Adds the rows, of `count` unknown numbers and then those of the known attitude, to an identification, which must
/// outlive it; null: to none. The results are for nobody.
struct IdentificationRows {
    std::size_t count = 0;
    Spec known;
    bool paired = false; ///< see ComparisonRows
    bool by_key = false;
};
[[nodiscard]] RowOperation identification_operation(const IdentificationRows& rows, Identification* identification);

} // namespace rotconv::stream
