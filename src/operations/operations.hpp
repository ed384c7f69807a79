#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/comparison.hpp>
#include <rotconv/continuous.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/identification.hpp>
#include <rotconv/product.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/sampling.hpp>
#include <rotconv/survey.hpp>

#include "../methods/method_conversion.hpp"
#include "../stream/row_operation.hpp"
#include "angle_statistics.hpp"

/// What commands do with rows of numbers: for each the numbers that it takes of a row, and the operation, in a source
/// of its name.
namespace rotconv::operations {

using Operation = std::shared_ptr<stream::RowOperation>;

/// The column names of a SPEC's numbers in the order in which they are written, each followed by the ending.
[[nodiscard]] std::vector<std::string> names_of(const Spec& spec, const std::string& ending = {});
/// The column names of an angular velocity.
[[nodiscard]] std::vector<std::string> velocity_names(bool degrees);
[[nodiscard]] std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& others);

/// The numbers of both attitudes of each row, one after the other; `room` for them where they have keys.
[[nodiscard]] std::span<const double> without_keys(std::span<const double> rows, const stream::PairColumns& columns,
                                                   std::vector<double>& room);

/// An operation whose results are attitudes; `continuous`, here and below: each follows the motion, see
/// ContinuousNumbers.
class AttitudeOperation : public stream::RowOperation {
public:
    AttitudeOperation(const Spec& to, bool continuous) : numbers_(std::make_shared<ContinuousNumbers>(to)) {
        names = names_of(to);
        attitudes = {to};
        is_continuous = continuous && numbers_->have_choice();
    }
    void make_continuous(std::span<double> results, std::span<const RowReport> reports) override {
        numbers_->run(results, reports, rest_);
    }

protected:
    /// Room for what the exact numbers have beside the results; none where that is not needed.
    [[nodiscard]] std::span<double> rest_of(std::span<const double> results) {
        rest_.resize(is_continuous ? results.size() : 0);
        return rest_;
    }

private:
    std::shared_ptr<ContinuousNumbers> numbers_; ///< of all threads
    std::vector<double> rest_;
};

/// The numbers of an attitude, perhaps after a key that passes through unchanged.
[[nodiscard]] stream::RowNumbers attitude_numbers(const Spec& spec, bool with_key = false);

/// The conversion of attitudes.
[[nodiscard]] Operation convert(const Conversion& conversion, bool continuous);

/// Several operations whose results are attitudes, one after the other. A diagnostic of any is one of the row, whose
/// margin is the least and whose condition the greatest.
[[nodiscard]] Operation several(std::vector<Operation> parts);

/// The answers of a published method; `all`: of all methods of the pair, each with its angle to the attitude.
[[nodiscard]] Operation method(const MethodConversion& conversion, bool all, bool continuous);

/// The vectors of rows of an attitude and a vector in reference coordinates.
[[nodiscard]] stream::RowNumbers rotation_numbers(const Spec& spec);
[[nodiscard]] Operation rotate(const VectorRotation& rotation);

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
    bool decimal = false;     ///< see ConversionSettings
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

/// The rows of a sampler, from their indices.
[[nodiscard]] Operation sample(const Spec& spec, const SampleSettings& settings);

/// The survey of attitudes, from rows of quaternions.
struct SurveyFold final : stream::Fold {
    void add(const stream::AnsweredRows& rows) override;

    Survey survey{};
};

/// Where the second attitude of a pair is.
struct PairedRows {
    bool paired = false;       ///< it comes from a reference, otherwise it follows the first in the row
    bool by_key = false;       ///< each of the two has its key before it
    bool interpolates = false; ///< by key: it lies between two of the reference, see stream::Pairing

    [[nodiscard]] stream::PairColumns columns(const Spec& first, const Spec& second) const noexcept {
        return {first.size(), second.size(), by_key, interpolates};
    }
};
/// The numbers that rows of the stream have: of both attitudes, or those of the first.
[[nodiscard]] stream::RowNumbers pair_numbers(const Spec& first, const Spec& second, const PairedRows& rows);

/// The products of pairs of attitudes.
[[nodiscard]] Operation compose(const Composition& composition, const PairedRows& rows, bool continuous);

struct ComparisonRows : PairedRows {
    bool with_attitudes = false; ///< both follow the angle, as quaternions
    std::size_t delta = 0;   ///< not 0: the turn from each pair to the so many-th after it, instead of the attitudes
    std::string_view unit{}; ///< of angles
};
/// The angles between the two attitudes of rows; nan where there is none.
[[nodiscard]] Operation compare(const Comparison& comparison, const ComparisonRows& rows);

/// A pair among those that differ most: the worst are first, of equals the earlier.
struct WorstPair {
    double angle = 0.0;
    std::size_t line = 0;
    std::size_t reference_line = 0;    ///< 0: there is no reference
    std::array<std::string, 2> keys{}; ///< of the row and of its partner; empty: they are not paired by key
    std::array<std::vector<double>, 2> attitudes{}; ///< their numbers, as they were read

    friend bool operator<(const WorstPair& a, const WorstPair& b) noexcept {
        return a.angle > b.angle || (a.angle == b.angle && a.line < b.line);
    }
};

/// An angle that so many of 100 pairs must not exceed, and the pairs that do.
struct PairLimit {
    double angle = 0.0;
    double percent = 100.0;
    std::size_t beyond = 0;
    std::size_t first_beyond = 0; ///< the least of their lines

    [[nodiscard]] bool holds(std::size_t pairs) const noexcept {
        // The product may be rounded up from a whole number.
        return 100.0 * static_cast<double>(pairs - beyond) >= percent * static_cast<double>(pairs) * (1.0 - 0x1p-50);
    }
};

/// What pairs are like together, those without an angle left out.
class PairFold final : public stream::Fold {
public:
    /// @param most as many of the worst are kept
    PairFold(const stream::PairColumns& columns, std::size_t most, std::vector<PairLimit> limits)
        : columns_(columns), most_(most), limits_(std::move(limits)) {}

    void add(const stream::AnsweredRows& rows) override;

    [[nodiscard]] std::size_t pairs() const noexcept { return angles_.count(); }
    [[nodiscard]] const AngleStatistics& angles() const noexcept { return angles_; }
    [[nodiscard]] const std::set<WorstPair>& worst() const noexcept { return worst_; }
    [[nodiscard]] const std::vector<PairLimit>& limits() const noexcept { return limits_; }
    /// The turn that brings each attitude to its reference from the left, and from the right; of rows with attitudes.
    [[nodiscard]] const MeanTurn& left() const noexcept { return left_; }
    [[nodiscard]] const MeanTurn& right() const noexcept { return right_; }

private:
    void keep(const stream::AnsweredRows& rows, std::size_t row);

    stream::PairColumns columns_;
    std::size_t most_;
    std::vector<PairLimit> limits_;
    AngleStatistics angles_;
    MeanTurn left_;
    MeanTurn right_;
    std::set<WorstPair> worst_;
};

/// The constant turns between the attitudes of pairs, from rows with attitudes.
struct AlignmentFold final : stream::Fold {
    explicit AlignmentFold(AlignedSide side) : alignment(side) {}
    void add(const stream::AnsweredRows& rows) override;

    Alignment alignment;
};

struct IdentificationRows {
    std::size_t count = 0; ///< unknown numbers; 0: not yet known
    Spec known{};
    bool paired = false; ///< see ComparisonRows
    bool by_key = false;
};
/// Adds rows, each of unknown numbers and then the known attitude, to an identification. The results are not used.
[[nodiscard]] stream::RowNumbers identification_numbers(const IdentificationRows& rows);
[[nodiscard]] Operation identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification);

} // namespace rotconv::operations
