#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <rotconv/conversion.hpp>

namespace rotconv {

/// A convention that numbers may have: a SPEC and an order of the columns.
struct Candidate {
    Spec spec;
    std::array<std::uint8_t, 9> columns{}; ///< for each number of the SPEC the column that holds it, from 0
    std::size_t rows = 0;                  ///< that it was tried on; it leaves with one that it does not fit by far
    double angle = 0.0; ///< the greatest to the known attitude, in radians; infinite where the numbers have no attitude
    std::size_t angle_row = 0; ///< the first row that has it
};

/// How many candidates fit, and where that is more than one what the rows lack.
struct Verdict {
    /// The first that holds.
    enum class Ambiguity : std::uint8_t {
        nothing,
        rows,       ///< there is one
        attitudes,  ///< all rows have the same
        size,       ///< all are small: `angle` is the greatest
        axes,       ///< all turn about one: `axis`
        zero,       ///< the number in `column` always is
        equal,      ///< those in `column` and `other` always are
        difference, ///< the rows agree by other chance
    };
    std::size_t fitting = 0;
    Ambiguity lack = Ambiguity::nothing;
    double angle = 0.0;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    std::size_t column = 0; ///< from 0
    std::size_t other = 0;
};

struct IdentificationSettings {
    double within = 1e-3;    ///< greatest angle of a candidate that fits, in radians, from 0
    double tolerance = 1e-3; ///< see ConversionSettings::tolerance; of the known attitude and of the unknown numbers
};

/// Finds the convention of numbers that come with the same attitude in a known one.
///
/// Tried are all SPECs with that count of numbers, with all modifiers and sequences, and for Euler angles and
/// quaternions all orders of the columns. Those that mean the same whatever the numbers count as one, called by the
/// one whose list of columns is the least, of these by one with the fewest modifiers, and rather without `passive`;
/// `rpy` is called euler:xyz. A candidate leaves with the first row that is beyond a thousand times the limit, or
/// whose numbers have no attitude in it: so wide data cost little more than one conversion. Constant memory.
class Identification {
public:
    /// `name`: the candidates are those of this representation alone, which has `count` numbers.
    Identification(std::size_t count, const Spec& known, std::optional<RepresentationId> name = {},
                   const IdentificationSettings& settings = {});

    /// Whether there is a representation with that count of numbers.
    [[nodiscard]] static bool is_count(std::size_t count) noexcept;
    /// The unknown numbers of a row.
    [[nodiscard]] std::size_t count() const noexcept { return count_; }

    /// The next rows, each of the unknown numbers and then those of the known attitude, and the number that each has
    /// for the caller. What comes of rows does not depend on how many are added at once.
    /// @param reports become those of rows with an error or a diagnostic of the known attitude. A row without a known
    /// attitude, or one that no candidate that is left can read, has an error and counts for nothing.
    void add(std::span<const double> numbers, std::span<const std::size_t> rows, std::vector<RowReport>& reports);

    /// That count.
    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    [[nodiscard]] bool fits(const Candidate& candidate) const noexcept {
        return rows_ > 0 && candidate.rows == rows_ && candidate.angle <= settings_.within;
    }
    /// Those that were tried longest first, and of these those with the smallest angle.
    [[nodiscard]] std::vector<Candidate> best_first() const;
    [[nodiscard]] Verdict verdict() const;

private:
    struct Trial {
        Candidate candidate;
        Conversion conversion;
    };

    /// Adds rows [first, first + count) of those at hand, of which known_ has the attitudes.
    void try_rows(std::span<const double> numbers, std::span<const std::size_t> rows, std::size_t first,
                  std::size_t count, std::vector<RowReport>& reports);
    /// The angles of rows [first, first + count) to their known attitudes.
    void measure(const Trial& trial, std::span<const double> numbers, std::size_t first, std::size_t count,
                 double* angles);
    /// Why the numbers of a row have no attitude.
    [[nodiscard]] RowReport refusal(const Trial& trial, const double* numbers);
    void remember(const double* numbers, const Rotation& known);
    [[nodiscard]] Verdict::Ambiguity lack(Verdict& verdict) const;

    std::size_t count_;
    IdentificationSettings settings_;
    Conversion known_conversion_;
    std::vector<Trial> trials_;       ///< in the order in which they are called
    std::vector<std::size_t> living_; ///< those that have not left
    std::size_t rows_ = 0;

    // What there is to tell of the rows.
    Rotation first_;
    double spread_ = 0.0;                               ///< greatest angle to the first
    double greatest_angle_ = 0.0;                       ///< of the attitudes
    Eigen::Matrix3d scatter_ = Eigen::Matrix3d::Zero(); ///< sum of u u' over the quaternions (w, u)
    std::array<double, 9> greatest_numbers_{};          ///< of each column, without signs
    /// Of each column and another one; its upper triangle counts.
    std::array<std::array<double, 9>, 9> greatest_differences_{};

    // Room of add().
    std::vector<double> known_numbers_;
    std::vector<double> known_; ///< quaternions, nan where there is none
    std::vector<double> ordered_;
    std::vector<double> tried_;
    std::vector<double> angles_; ///< of the living, a batch each
    std::vector<RowReport> found_;
};

} // namespace rotconv
