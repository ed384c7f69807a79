#pragma once

#include <array>
#include <span>

#include <rotconv/conversion.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// Follows a motion: of all numbers that mean an attitude (the sign of a quaternion or of an axis, whole turns, the
/// other triple of Euler angles) it writes those nearest to the last row's, by the sum of the squares of their
/// differences, angles in radians; of equals the canonical ones. At gimbal lock the third angle keeps its last value,
/// at the identity, after any number of whole turns, the axis.
class ContinuousNumbers {
public:
    explicit ContinuousNumbers(const Spec& spec) noexcept;

    /// An attitude has other numbers than the canonical ones; else run() changes nothing.
    [[nodiscard]] bool have_choice() const noexcept;

    /// Goes on with rows of spec.size() numbers in the order of the motion, as Conversion::run() has made them with
    /// those reports. The very first row is left as it is. So is a row that has an error or a number that is not
    /// finite; the next row is not compared with it.
    /// @param rest what the exact numbers have beside those, so that the numbers chosen are rounded once; or empty
    void run(std::span<double> numbers, std::span<const RowReport> reports, std::span<const double> rest = {}) noexcept;

private:
    Spec spec_;
    const Codec* codec_;
    bool has_last_ = false;
    std::array<double, 4> last_{}; ///< as they are written; none with a choice has more
};

} // namespace rotconv
