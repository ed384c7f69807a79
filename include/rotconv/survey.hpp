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

/// What a stream of attitudes demands of one set of parameters.
struct SetSurvey {
    Spec set;
    double least_margin = 0.0;       ///< radians, see Sensitivity
    std::size_t margin_row = 0;      ///< the first row that has it
    double greatest_condition = 0.0; ///< see Sensitivity
    std::size_t condition_row = 0;   ///< the first row that has it
    std::size_t jumps = 0;           ///< see Survey
    std::size_t jump_row = 0;        ///< the first row that is jumped to

    /// The condition is finite and at most `limit`, and there are no jumps. Those of the quaternion do not count: they
    /// change its sign alone, which means the same attitude, and its equation knows no singular one.
    [[nodiscard]] bool serves(double limit) const noexcept {
        return std::isfinite(greatest_condition) && greatest_condition <= limit &&
               (jumps == 0 || set.name == RepresentationId::quat);
    }
};

/// Follows a stream of attitudes in every set at once: dcm, 6d, 5d, quat, axis-angle, rotvec, the twelve intrinsic
/// Euler sequences (the extrinsic ones are the same angles read backwards), cayley, mrp. Constant memory.
///
/// A jump is counted where the parameters, in the ranges in which they are printed, do not follow the motion. The
/// shortest rotation from one row to the next, cut in equal parts of at most 1 radian, is halved, and always that half
/// again on which they change more (of equals the first), until they change by 1 (radian) at most; it is a jump where,
/// on one of the parts or their halves, they change by more than 1 and by more than twice the part's angle times the
/// greater condition of the two rows (1e15 at most). These are the wraps of angles and rotation vectors, shadow
/// switches, changes of sign, and steps across gimbal lock; however far apart the rows are.
class Survey {
public:
    Survey();

    /// The next attitude, and the number that its row has for the caller.
    void add(const Rotation& rotation, std::size_t row) noexcept;

    [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
    /// In the order of the table of representations.
    [[nodiscard]] std::span<const SetSurvey> sets() const noexcept { return sets_; }
    /// Of the sets that serve the one with the fewest parameters, and of these the one with the smallest greatest
    /// condition; null where none serves.
    [[nodiscard]] const SetSurvey* smallest(double limit) const noexcept;

private:
    /// One set at the latest row.
    struct State {
        Eigen::Matrix<double, 9, 1> numbers = Eigen::Matrix<double, 9, 1>::Zero();
        double condition = 0.0;
    };

    std::vector<SetSurvey> sets_;
    std::vector<State> states_;
    std::array<double, 4> latest_{1.0, 0.0, 0.0, 0.0}; ///< w, x, y, z
    std::size_t rows_ = 0;
};

} // namespace rotconv
