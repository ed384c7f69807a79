#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <rotconv/comparison.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/identification.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/survey.hpp>

#include "../methods/method_conversion.hpp"
#include "../stream/row_operation.hpp"

/// What commands do with rows of numbers: for each the numbers that it takes of a row, and the operation, in a source
/// of its name.
namespace rotconv::operations {

using Operation = std::shared_ptr<stream::RowOperation>;

/// The column names of a SPEC's numbers in the order in which they are written, each followed by the ending.
[[nodiscard]] std::vector<std::string> names_of(const Spec& spec, const std::string& ending = {});
/// The column names of an angular velocity.
[[nodiscard]] std::vector<std::string> velocity_names(bool degrees);
[[nodiscard]] std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& others);

/// Removes the keys from rows of a key, n numbers, another key and m numbers. The result holds until the next call.
class KeyRemover {
public:
    std::span<const double> operator()(std::span<const double> rows, std::size_t n, std::size_t m);

private:
    std::vector<double> room_;
};

/// The numbers of an attitude, perhaps after a key that passes through unchanged.
[[nodiscard]] stream::RowNumbers attitude_numbers(const Spec& spec, bool with_key = false);

/// The conversion of attitudes; `continuous`, here and below: each result follows the motion, see ContinuousNumbers.
[[nodiscard]] Operation convert(const Conversion& conversion, bool continuous);

/// The answers of a published method; `all`: of all methods of the pair, each with its angle to the attitude.
[[nodiscard]] Operation method(const MethodConversion& conversion, bool all, bool continuous);

/// The kinematic equation of a representation: the rates' columns have the names of the numbers and `_rate`, or are
/// those of an angular velocity. `sensitivity`: a report of every row.
[[nodiscard]] stream::RowNumbers rates_numbers(const Spec& spec, const RateSettings& settings);
[[nodiscard]] Operation rates(const Spec& spec, const RateSettings& settings);

struct DifferenceSettings {
    Spec spec{};          ///< of the attitude
    int time_power = 0;   ///< times are in units of 10^time_power seconds, 0 or less
    bool degrees = false; ///< the angular velocity in degrees a second
    Frame frame = Frame::body;
    double tolerance = 0.0;   ///< see ConversionSettings
    bool sensitivity = false; ///< a report of every row
};
/// The angular velocity since the row before, from rows of a time and an attitude: the rotation vector from the earlier
/// attitude to the later one over the time between them. The first row has the velocity of the second, nan if there is
/// none.
[[nodiscard]] stream::RowNumbers difference_numbers(const Spec& spec);
[[nodiscard]] Operation differences(const DifferenceSettings& settings);

struct PropagationRows {
    PropagationSettings settings{};
    int time_power = 0;   ///< times are in units of 10^time_power seconds, 0 or less
    bool degrees = false; ///< the angular velocity in degrees a second
    Spec to{};            ///< the representation in which the attitudes are written
    ConversionSettings conversion{};
    bool continuous = false;
    bool stop_at_error = true; ///< the first error is the end
};
/// The attitudes of a propagation, from rows t, wx, wy, wz.
[[nodiscard]] stream::RowNumbers propagation_numbers();
[[nodiscard]] Operation propagate(const PropagationRows& rows);

/// Adds the attitudes to a survey, which must outlive the operation. The results of the rows are not used.
[[nodiscard]] Operation survey(const Spec& from, double tolerance, Survey& survey);

struct ComparisonRows {
    bool paired = false;       ///< the second attitude comes from a reference...
    bool by_key = false;       ///< ...and each of the two has its key before it
    bool with_line = false;    ///< the row's line after the angle, instead of the relative attitude
    bool interpolates = false; ///< by key: the second attitude lies between two of the reference, see stream::Pairing
};
/// The angles between the two attitudes of rows.
[[nodiscard]] stream::RowNumbers comparison_numbers(const Comparison& comparison, const ComparisonRows& rows);
[[nodiscard]] Operation compare(const Comparison& comparison, const ComparisonRows& rows);

struct IdentificationRows {
    std::size_t count = 0; ///< unknown numbers; 0: not yet known
    Spec known{};
    bool paired = false; ///< see ComparisonRows
    bool by_key = false;
};
/// Adds rows, each of unknown numbers and then the known attitude, to the identification that the function returns.
/// The results of the rows are not used. `positions` becomes the fields that hold the unknown numbers.
[[nodiscard]] stream::RowNumbers identification_numbers(const IdentificationRows& rows);
[[nodiscard]] Operation identify(const IdentificationRows& rows, std::function<Identification&()> identification,
                                 std::vector<std::size_t>& positions);

} // namespace rotconv::operations
