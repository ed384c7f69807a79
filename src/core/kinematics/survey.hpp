#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <rotconv/rotation.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// What a stream of attitudes demands of one representation.
struct RepresentationSurvey {
    Spec spec;
    double least_margin = 0.0;       ///< radians, see Sensitivity
    std::size_t margin_row = 0;      ///< the first row with that margin
    double greatest_condition = 0.0; ///< see Sensitivity
    std::size_t condition_row = 0;   ///< the first row with that condition
    std::size_t jumps = 0;           ///< see Survey
    std::size_t jump_row = 0;        ///< the row after the first jump

    /// The condition is finite and at most `limit`, and there are no jumps. Jumps of the quaternion do not count: they
    /// are only changes of sign, which keep the attitude, and its equation has no singular attitude.
    [[nodiscard]] bool serves(double limit) const noexcept {
        return std::isfinite(greatest_condition) && greatest_condition <= limit &&
               (jumps == 0 || spec.name == RepresentationId::quat);
    }
};

/// Follows a stream of attitudes in all representations at once: dcm, 6d, 5d, quat, axis-angle, rotvec, the twelve
/// intrinsic Euler sequences (the extrinsic ones are the same angles read backwards), cayley, mrp. Constant memory.
///
/// A jump is counted where the numbers, in the ranges in which they are printed, do not follow the motion. The shortest
/// rotation from one row to the next is cut into equal parts of at most 1 radian. Each part is halved; then the half
/// over which the numbers change more (the first, if they are equal) is halved in turn, and so on until the change is
/// at most 1 (radian). There is a jump if, over any part or half, the numbers change by more than 1 and also by more
/// than 2 a c, where a is the angle of that part or half and c is the greater condition of the two rows (1e15 at most).
/// Wraps of angles and rotation vectors, shadow switches, changes of sign and steps across gimbal lock are jumps,
/// however far apart the rows are.
class Survey {
public:
    Survey();

    /// The next attitude, and the number of its row for the caller.
    void add(const Rotation& rotation, std::size_t row) noexcept;

    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    /// In the order of the table of representations.
    [[nodiscard]] std::span<const RepresentationSurvey> representations() const noexcept { return surveys_; }
    /// The representation that serves with the fewest numbers; of several, the one whose largest condition is smallest.
    /// Null if none serves.
    [[nodiscard]] const RepresentationSurvey* smallest(double limit) const noexcept;

private:
    /// One representation at the latest row.
    struct State {
        Eigen::Matrix<double, 9, 1> numbers = Eigen::Matrix<double, 9, 1>::Zero();
        double condition = 0.0;
    };

    std::vector<RepresentationSurvey> surveys_;
    std::vector<State> states_;
    std::array<double, 4> latest_{1.0, 0.0, 0.0, 0.0}; ///< w, x, y, z
    std::size_t rows_ = 0;
};

} // namespace rotconv
