#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/comparison.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/product.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/sampling.hpp>

#include "../core/identification/identification.hpp"
#include "../core/kinematics/survey.hpp"
#include "../methods/method_conversion.hpp"
#include "../stream/rows/row_operation.hpp"
#include "angle_statistics.hpp"

/// The operations on rows of numbers, each in a source of its name.
namespace rotconv::operations {

using Operation = std::shared_ptr<stream::RowOperation>;

/// The column names of a SPEC's numbers in the order in which they are written, each followed by the ending.
[[nodiscard]] std::vector<std::string> names_of(const Spec& spec, const std::string& ending = {});
/// The column names of an angular velocity.
[[nodiscard]] std::vector<std::string> velocity_names(bool degrees);
[[nodiscard]] std::vector<std::string> concatenated(std::vector<std::string> names,
                                                    const std::vector<std::string>& others);

using stream::RowFunction;

/// The function of a Conversion, Rates and the like.
template <class Core> RowFunction function_of(const Core& core) {
    return [core](const stream::NumberRows& rows, auto out, auto& reports, [[maybe_unused]] auto rest) {
        if constexpr (requires { core.run(rows.numbers, out, reports, rest); }) {
            core.run(rows.numbers, out, reports, rest);
        } else {
            core.run(rows.numbers, out, reports);
        }
        return rows.lines.size();
    };
}

/// An operation whose results are numbers of those names.
[[nodiscard]] Operation operation_of(RowFunction function, stream::RowNumbers input, std::vector<std::string> names);
/// An operation whose results are attitudes. `continuous`, here and below: they follow the motion, see
/// ContinuousNumbers.
[[nodiscard]] Operation operation_of(RowFunction function, stream::RowNumbers input, const Spec& to, bool continuous);

[[nodiscard]] stream::RowNumbers attitude_numbers(const Spec& spec);

/// The conversion of attitudes.
[[nodiscard]] Operation convert(const Conversion& conversion, bool continuous);

/// Several operations whose results are attitudes, one after the other.
[[nodiscard]] Operation several(const std::vector<Operation>& operations);

/// The answers of a published method.
[[nodiscard]] Operation method(const MethodConversion& conversion, bool continuous);

/// The answers of several methods to a row, see MethodConversion::run().
struct MethodAnswers {
    std::vector<double> numbers;
    std::vector<double> angles;
};
/// Keeps the answers of methods of one pair to a single row. The results are not used.
[[nodiscard]] Operation all_methods(const std::vector<MethodConversion>& methods,
                                    std::shared_ptr<MethodAnswers> answers);

/// The vectors that are rotated by the attitudes of their rows, see VectorRotation.
[[nodiscard]] Operation rotate(const VectorRotation& rotation);

/// The kinematic equation of a representation. The result's columns have the names of the numbers with `_rate`, or are
/// those of an angular velocity. RateSettings::sensitivity: a report of every row.
[[nodiscard]] Operation rates(const Spec& spec, const RateSettings& settings);

/// The angular velocity since the previous row, from rows of a time and an attitude: the rotation vector from the
/// earlier attitude to the later one over the time between them. The first row has the second row's velocity, or nan.
/// @param time_power times are in units of 10^time_power seconds, 0 or less
[[nodiscard]] Operation differences(const Spec& spec, const RateSettings& settings, int time_power);

struct PropagationRows {
    PropagationSettings settings{};
    int time_power = 0;   ///< times are in units of 10^time_power seconds, 0 or less
    bool degrees = false; ///< the angular velocity is in degrees a second
    Spec to{};            ///< the representation in which the attitudes are written
    ConversionSettings conversion{};
    bool continuous = false;
    bool stop_at_error = true; ///< the first error ends the propagation
};
/// The attitudes of a propagation, from rows t, wx, wy, wz.
[[nodiscard]] Operation propagate(const PropagationRows& rows);

/// The rows of a sampler, from rows of an index from 0 on.
[[nodiscard]] Operation sample(const Spec& spec, const SampleSettings& settings);

/// The survey of attitudes, from rows of quaternions.
struct SurveyFold final : stream::Fold {
    void add(const stream::AnsweredRows& rows) override;

    Survey survey{};
};

/// Where the second attitude of a pair stands.
struct PairedRows {
    bool paired = false;       ///< it comes from a reference; otherwise it follows the first in the row
    bool by_key = false;       ///< each attitude has its key before it
    bool interpolates = false; ///< it is interpolated in the reference, see stream::Pairing
};

/// The numbers of a row: its own, after the key if there is one, and those of the second attitude if it is in the row.
[[nodiscard]] stream::RowNumbers pair_numbers(stream::RowNumbers numbers, const PairedRows& rows,
                                              const Spec& second = {});

/// The products of pairs of attitudes.
[[nodiscard]] Operation compose(const Composition& composition, const PairedRows& rows, bool continuous);

struct ComparisonRows : PairedRows {
    bool with_attitudes = false; ///< both attitudes follow the angle, as quaternions
    std::size_t delta = 0;       ///< not 0: compares rotations from each pair to the delta-th after it
    std::string_view unit{};     ///< the angles' unit
};
/// The angle between the two attitudes of each row; nan if there is none.
[[nodiscard]] Operation compare(const Comparison& comparison, const ComparisonRows& rows);

/// A pair among those that differ most. The largest angle comes first; the earlier line, if angles are equal.
struct WorstPair {
    double angle = 0.0;
    std::size_t line = 0;
    std::size_t reference_line = 0;                 ///< 0: there is no reference
    std::array<std::string, 2> keys{};              ///< the row's and its partner's; empty: they are not paired by key
    std::array<std::vector<double>, 2> attitudes{}; ///< the numbers of both, as they were read

    friend bool operator<(const WorstPair& a, const WorstPair& b) noexcept {
        return a.angle > b.angle || (a.angle == b.angle && a.line < b.line);
    }
};

/// Whether a part of all is at least so many in 100 of them.
[[nodiscard]] inline bool is_share(std::size_t part, double percent, std::size_t all) noexcept {
    // The product may be rounded up from a whole number.
    return 100.0 * static_cast<double>(part) >= percent * static_cast<double>(all) * (1.0 - 0x1p-50);
}

/// An angle that `percent` of the pairs must not exceed, and the pairs that do.
struct PairLimit {
    std::string text{}; ///< the angle as it is given, with its unit
    std::string name{}; ///< of the figure that it limits: max, or such as p95
    double angle = 0.0; ///< in the unit of the pairs' angles
    double percent = 100.0;
    std::size_t beyond = 0;
    std::size_t first_beyond = 0; ///< the first of their lines

    [[nodiscard]] bool is_of_all() const noexcept { return percent == 100.0; }
    [[nodiscard]] bool holds(std::size_t pairs) const noexcept { return is_share(pairs - beyond, percent, pairs); }
};

/// The statistics of pairs, without those that have no angle.
class PairFold final : public stream::Fold {
public:
    /// @param most how many of the worst pairs are kept
    PairFold(const Comparison& comparison, const ComparisonRows& rows, std::size_t most, std::vector<PairLimit> limits)
        : first_size_(comparison.from().size()), interpolates_(rows.interpolates),
          finds_means_(rows.with_attitudes && rows.delta == 0), most_(most), limits_(std::move(limits)) {}

    void add(const stream::AnsweredRows& rows) override;

    [[nodiscard]] std::size_t pairs() const noexcept { return angles_.count(); }
    [[nodiscard]] const AngleStatistics& angles() const noexcept { return angles_; }
    [[nodiscard]] const std::set<WorstPair>& worst() const noexcept { return worst_; }
    [[nodiscard]] const std::vector<PairLimit>& limits() const noexcept { return limits_; }
    /// The mean rotation from the attitudes to their references, from the left and from the right; for rows with
    /// attitudes, without a delta.
    [[nodiscard]] const MeanRotation& left() const noexcept { return left_; }
    [[nodiscard]] const MeanRotation& right() const noexcept { return right_; }

private:
    void keep(const stream::AnsweredRows& rows, std::size_t row);

    std::size_t first_size_; ///< numbers of the first attitude
    bool interpolates_;
    bool finds_means_;
    std::size_t most_;
    std::vector<PairLimit> limits_;
    AngleStatistics angles_;
    MeanRotation left_;
    MeanRotation right_;
    std::set<WorstPair> worst_;
};

/// The constant rotations between the attitudes of pairs, from rows with attitudes.
struct AlignmentFold final : stream::Fold {
    explicit AlignmentFold(AlignedSide side) : alignment(side) {}
    void add(const stream::AnsweredRows& rows) override;

    Alignment alignment;
};

struct IdentificationRows : PairedRows {
    std::size_t count = 0; ///< unknown numbers; 0: not yet known
    Spec known{};
};
/// Adds rows, each of unknown numbers and then the known attitude, to an identification. The results are not used.
[[nodiscard]] Operation identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification);

} // namespace rotconv::operations
