#pragma once

#include <cstddef>

#include <rotconv/reading.hpp>

#include "../numerics/elementary.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "attitude_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// A quaternion with the sign that is printed, its vector part and the length of that. The length and the angle count
/// in every number, the angle twice: they are precise.
template <class T> struct AxisHalfAngle {
    ROTCONV_INLINE AxisHalfAngle() noexcept = default;
    /// @param q w, x, y, z
    ROTCONV_INLINE explicit AxisHalfAngle(const T (&q)[4]) noexcept {
        const double sign = canonical_sign(sign_of(q[0]), sign_of(q[1]), sign_of(q[2]), sign_of(q[3]));
        w = scaled(q[0], sign);
        x = scaled(q[1], sign);
        y = scaled(q[2], sign);
        z = scaled(q[3], sign);
        length = root(sum_of_squares(x, y, z));
    }

    /// Of the turn.
    [[nodiscard]] Precise<T> angle(AngleUnit unit) const noexcept {
        return scaled(angle_of(w, narrowed<T>(length), unit), 2.0);
    }
    /// pi - theta <= half_turn_margin.
    [[nodiscard]] ROTCONV_INLINE DiagnosticSet diagnostics() const noexcept {
        return {DiagnosticKind::half_turn, to_double(w) <= 0.5 * half_turn_margin * to_double(length)};
    }

    T w, x, y, z;
    Precise<T> length; ///< of (x, y, z)
};

/// Those of a batch.
template <class T> struct AxisHalfAngles {
    AxisHalfAngles(const AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
        for (std::size_t i = 0; i < rows; ++i) {
            T own[4];
            attitudes.get(i, own);
            const AxisHalfAngle<T> parts(own);
            w.set(i, parts.w);
            x.set(i, parts.x);
            y.set(i, parts.y);
            z.set(i, parts.z);
            length.set(i, parts.length);
        }
    }
    [[nodiscard]] ROTCONV_INLINE AxisHalfAngle<T> operator[](std::size_t row) const noexcept {
        AxisHalfAngle<T> parts;
        parts.w = w[row];
        parts.x = x[row];
        parts.y = y[row];
        parts.z = z[row];
        parts.length = length[row];
        return parts;
    }

    /// Of the turns.
    void find_angles(std::size_t rows, AngleUnit unit, Column<DoubleDouble>& angles) const noexcept {
        Column<T> sides;
        for (std::size_t i = 0; i < rows; ++i) {
            sides.set(i, rounded_to<T>(length[i]));
        }
        angles_of(w, sides, rows, unit, angles);
        for (std::size_t i = 0; i < rows; ++i) {
            angles.set(i, scaled(angles[i], 2.0));
        }
    }

    Column<T> w, x, y, z;
    Column<DoubleDouble> length;
};

} // namespace ROTCONV_TARGET
} // namespace rotconv
