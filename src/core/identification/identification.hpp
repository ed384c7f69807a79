#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <rotconv/alignment.hpp>
#include <rotconv/conversion.hpp>

namespace rotconv {

/// For each number of a SPEC the column that holds it, from 0.
using ColumnOrder = std::array<std::uint8_t, 9>;

/// A convention that the numbers may have: a SPEC and an order of the columns.
struct Candidate {
    Spec spec;
    ColumnOrder columns{};
    std::size_t rows = 0; ///< on which it was tried: all, those that were kept, or those until it was dropped
    double angle = 0.0;   ///< largest angle to the known attitude, radians; infinite if a row has no attitude in it
    std::size_t angle_row = 0;         ///< the first row with that angle
    ConstantRotations constant{};      ///< known = left unknown right
    std::string_view reference_axes{}; ///< the name of the left one, such as "ned:enu", if it has one
    std::string_view body_axes{};      ///< the name of the right one's inverse, if it has one

    /// Whether the SPEC has no signs, and its columns are in order.
    [[nodiscard]] bool is_plain() const noexcept;
    /// One more row on which it was tried, with the angle there.
    void add(double row_angle, std::size_t row) noexcept;
};

/// How many candidates fit and, if more than one does, why the rows do not tell them apart.
struct Verdict {
    /// The first reason that holds.
    enum class Ambiguity : std::uint8_t {
        nothing,
        rows,       ///< there is only one row
        attitudes,  ///< all rows have the same attitude
        size,       ///< all attitudes are small: `angle` is the largest
        axes,       ///< all attitudes turn about one axis: `axis`
        plane,      ///< the axes of the rotations between the attitudes lie in a plane with the normal `axis`
        zero,       ///< the number in `column` is always 0
        equal,      ///< the numbers in `column` and `other` are always equal
        difference, ///< the candidates agree on these rows for another reason
    };
    std::size_t fitting = 0;
    /// Best first, as best_first() has them. If none fits, those that fit with constant rotations are before them.
    std::vector<Candidate> candidates;
    Ambiguity ambiguity = Ambiguity::nothing;
    /// What fits, as a person would write it, if nothing is ambiguous.
    std::optional<Candidate> answer{};
    double angle = 0.0;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    std::size_t column = 0; ///< from 0
    std::size_t other = 0;
};

struct IdentificationSettings {
    double within = 1e-3;                 ///< largest angle of a candidate that fits, radians, from 0
    double tolerance = default_tolerance; ///< of the known attitude and the unknown numbers; see ConversionSettings
};

/// Finds the convention of numbers that come with the same attitude in a known one.
///
/// All SPECs with that count of numbers are tried, with all modifiers, sequences and their signs, with three angles in
/// all orders of the columns, axis-angle with the angle first too, and two columns interleaved too. Candidates that
/// mean the same for all numbers count as one, under the name with the fewest modifiers and signs. A candidate is
/// dropped at the first row that it misses by more than a thousand times the limit or by half a radian, or whose
/// numbers have no attitude in it.
///
/// All candidates are tried on the first `rows_for_all` rows. From then on only those that fit are, at most
/// `most_living`; where none fits, the nearest. Long data therefore cost little more than one conversion, also where
/// all motions are small. The others rest: those that fit so far are tried on each row where one of the living stops
/// fitting, and take its place. At the end the nearest that have not been tried on all rows are held against those
/// that were kept. A candidate that fits all rows is always found; one that was not tried on all rows, see
/// Candidate::rows, may fit only those.
///
/// If none fits, each is tried with a constant rotation on either side, see Alignment, and with the pairs of axes on
/// both sides that have names. Rows are kept: all up to `most_kept`, otherwise every second, fourth, eighth and so on.
/// Constant memory.
class Identification {
public:
    /// @param name if given, only candidates of this representation, which has `count` numbers
    Identification(std::size_t count, const Spec& known, std::optional<RepresentationId> name = {},
                   const IdentificationSettings& settings = {});

    /// Holds all rows against one candidate, with its constant rotations.
    Identification(const Candidate& candidate, const Spec& known, const IdentificationSettings& settings);

    /// Whether there is a representation with that count of numbers.
    [[nodiscard]] static bool is_count(std::size_t count) noexcept;
    /// The count of unknown numbers in a row.
    [[nodiscard]] std::size_t count() const noexcept { return count_; }

    /// The next rows: in each, the unknown numbers and then those of the known attitude. The result does not depend on
    /// how many rows are added at once.
    /// @param rows the number of each row for the caller
    /// @param reports is replaced by the reports of rows with an error, or with a diagnostic of the known attitude. A
    /// row without a known attitude, or which no remaining candidate can read, has an error and does not count
    /// @throw std::invalid_argument if there are fewer numbers than these rows have
    void add(std::span<const double> numbers, std::span<const std::size_t> rows, std::vector<RowReport>& reports);

    /// The count of rows so far, without those with an error.
    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    [[nodiscard]] bool fits(const Candidate& candidate) const noexcept {
        return rows_ > 0 && candidate.angle <= settings_.within;
    }
    /// The candidates that were tried on the most rows first; among these, in order of their angles.
    [[nodiscard]] std::vector<Candidate> best_first() const;
    [[nodiscard]] Verdict verdict() const;
    /// Whether the rows determine the constant rotations of a candidate that fits within that angle, if it has some:
    /// there are two rows, of different attitudes, and the rotations between them do not lie in a plane, or about an
    /// axis, in such a way that a change of axes could be mistaken for another convention.
    [[nodiscard]] bool do_rows_suffice(const Candidate& candidate, double within) const;

    static constexpr std::size_t most_kept = 65'536;
    static constexpr std::size_t rows_for_all = 256;
    static constexpr std::size_t most_living = 4;

private:
    struct Rows {
        std::vector<double> numbers; ///< the unknown ones
        std::vector<Rotation> known;
        std::vector<std::size_t> rows; ///< the number of each for the caller
    };

    /// Adds rows [first, first + count) of those being added, or those up to one after which others are living. Their
    /// attitudes are in known_. Returns how many it added.
    std::size_t try_rows(std::span<const double> numbers, std::span<const std::size_t> rows, std::size_t first,
                         std::size_t count, std::vector<RowReport>& reports);
    /// Whether a remaining candidate can read the row; if all are dropped, whether any of them can.
    [[nodiscard]] bool is_read(std::span<const double> numbers) const;
    /// Chooses those that live after a row, the last one.
    void choose_living(std::span<const double> numbers, const Rotation& known, std::size_t row);
    [[nodiscard]] bool is_dropped(const Candidate& candidate) const noexcept;
    /// The angle to the known attitude; infinite if `own`, see attitudes_of(), is none.
    static double angle_of_row(const Candidate& candidate, const Rotation& own, const Rotation& known) noexcept;
    /// The attitudes that the candidate makes of rows of `width` numbers, the unknown ones first; see is_attitude().
    static std::vector<Rotation> attitudes_of(const Candidate& candidate, double tolerance,
                                              std::span<const double> numbers, std::size_t width,
                                              std::vector<RowReport>& reports, bool fast = false);
    /// Those that a conversion to quaternions makes of the numbers in these columns.
    static std::vector<Rotation> attitudes_by(const Conversion& conversion, const ColumnOrder& columns,
                                              std::span<const double> numbers, std::size_t width,
                                              std::vector<RowReport>& reports);
    /// False for the nan that stand for numbers without an attitude.
    [[nodiscard]] static bool is_attitude(const Rotation& rotation) noexcept { return rotation.w() == rotation.w(); }
    /// Attitudes that a candidate makes of `generic_numbers_`, with its constant rotations.
    [[nodiscard]] std::vector<Rotation> generic_attitudes(const Candidate& candidate) const;
    void remember(std::span<const double> numbers, const Rotation& known, std::size_t row);
    [[nodiscard]] Verdict::Ambiguity ambiguity(Verdict& verdict) const;
    /// Some of the kept rows.
    [[nodiscard]] Rows some_rows(const std::vector<std::size_t>& places) const;
    /// The attitudes that the candidate makes of rows; empty if it cannot read one of them.
    [[nodiscard]] std::vector<Rotation> attitudes_or_none(const Candidate& candidate, const Rows& rows) const;
    /// The candidate held against these rows alone, up to the first at which it is dropped.
    [[nodiscard]] Candidate held(const Candidate& candidate, const Rows& rows, bool fast = false) const;
    /// The same to six digits, in plain double where that is enough.
    [[nodiscard]] Candidate held_quickly(const Candidate& candidate, const Rows& rows) const;
    /// Replaces the nearest candidates, as many as are looked at, by what `hold` makes of them.
    void hold_nearest(std::vector<Candidate*> nearest, const std::function<void(Candidate&)>& hold) const;
    /// Those that fit with constant rotations, of which the nearest leaves an angle not below a tenth of another's.
    [[nodiscard]] std::vector<Candidate> rotated() const;
    /// Of candidates that fit some rows those that fit all that are kept, one of each meaning, the nearest first.
    [[nodiscard]] std::vector<Candidate> different(std::vector<Candidate> found) const;
    /// Whether a project's SPEC has the angles of the candidate, in either unit, or is its inverse.
    /// @pre the candidate is not plain
    [[nodiscard]] bool is_of_project(const Candidate& candidate) const;
    /// The same meaning as a person would write it: a SPEC without signs, its columns as they stand; a project's; one
    /// without signs with axes that have names; otherwise the candidate.
    [[nodiscard]] Candidate as_written(const Candidate& candidate) const;

    std::size_t count_;
    IdentificationSettings settings_;
    Conversion known_conversion_;
    std::vector<double> generic_numbers_; ///< rows whose attitudes are equal only in candidates that mean the same
    std::vector<Candidate> candidates_;   ///< preferred names first
    std::vector<std::size_t> living_;     ///< those that are tried on each row
    std::size_t rows_ = 0;

    // The rows that are kept: every `stride_`-th.
    std::size_t stride_ = 1;
    Rows kept_;

    // For verdict(), over all rows:
    double spread_ = 0.0;                               ///< largest sin^2(theta/2) from the first
    double greatest_angle_ = 0.0;                       ///< largest sin^2(theta/2) of an attitude
    Eigen::Matrix3d scatter_ = Eigen::Matrix3d::Zero(); ///< sum of u u' over the quaternions (w, u)
    std::array<double, 9> greatest_numbers_{};          ///< largest magnitude in each column
    /// The same of the difference of two columns, i < k.
    std::array<std::array<double, 9>, 9> greatest_differences_{};

    // Buffers of add().
    std::vector<Rotation> known_; ///< see is_attitude()
    std::vector<double> angles_;  ///< one batch for each candidate
    std::vector<RowReport> found_;
};

} // namespace rotconv
