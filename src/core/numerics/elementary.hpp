#pragma once

#include <cstddef>

#include <rotconv/angle.hpp>

#include "approximate.hpp"
#include "row_batch.hpp"
#include "trigonometric_tables.hpp"
#include "wide.hpp"

// The project's own sine, cosine and arc tangent: plain sums and products of doubles, the same bits on every machine. T
// is the scalar of their accuracy: double, DoubleDouble or, for batches, Approximate.

namespace rotconv {
inline namespace ROTCONV_TARGET {

/// The nearest double, and the one nearest to what is beside it.
// NOLINTNEXTLINE(bugprone-exception-escape): see wide.hpp
[[nodiscard]] inline DoubleDouble rounded_parts(const Wide& a) noexcept {
    const double high = a.rounded();
    return {high, (a - Wide(high)).rounded()};
}

inline constexpr DoubleDouble exact_pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble exact_radians_per_degree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
inline constexpr DoubleDouble exact_degrees_per_radian{0x1.ca5dc1a63c1f8p+5, -0x1.1e7ab456405f9p-49};

/// A half-turn.
[[nodiscard]] ROTCONV_INLINE DoubleDouble half_turn_in(AngleUnit unit) noexcept {
    return unit == AngleUnit::degrees ? DoubleDouble(180.0) : exact_pi;
}

/// 1 in the unit, in radians.
[[nodiscard]] ROTCONV_INLINE DoubleDouble unit_in_radians(AngleUnit unit) noexcept {
    return unit == AngleUnit::degrees ? exact_radians_per_degree : DoubleDouble(1.0);
}

/// The sine and cosine of an angle in radians or degrees: as DoubleDouble each to 2^-103 of itself, where the angle is
/// a double of any size or, as a sum, not nearer to a zero than to its own error; as doubles to 2^-51.5. Multiples of
/// 90 degrees are exact.
template <class T> [[nodiscard]] SineCosine<T> sine_cosine(DoubleDouble angle, AngleUnit unit) noexcept;
// NOLINTNEXTLINE(bugprone-exception-escape)
[[nodiscard]] inline SineCosine<Wide> sine_cosine(const Wide& angle, AngleUnit unit) noexcept {
    SineCosine<Wide> both;
    Wide::sine_cosine(angle, unit == AngleUnit::degrees, both.sine, both.cosine);
    return both;
}
/// Those of half an angle below 2^13 radians, which need not be normalised, as doubles, by a short chain of operations.
[[nodiscard]] SineCosine<double> half_sine_cosine(DoubleDouble angle) noexcept;
/// Those of a batch of rows, each angle 0 or at least 2^-300. As Approximate, from angles that are doubles, each is
/// right to 2^-63 of itself, and both, as a vector, to 0x1.3p-69.
template <class T> void sine_cosine(const Column<DoubleDouble>& angles, std::size_t rows, AngleUnit unit,
                                    Column<T>& cosines, Column<T>& sines) noexcept;

/// Taylor's series of an angle up to 0.025, to less than its last digit: sine less the angle, and cosine less 1.
struct SmallAngle {
    ROTCONV_INLINE explicit SmallAngle(double angle) noexcept {
        const double s = angle * angle;
        sine_rest = angle * s * (-0x1.5555555555555p-3 + s * (0x1.1111111111111p-7 + s * -0x1.a01a01a01a01ap-13));
        cosine_less_1 = s * (-0.5 + s * (0x1.5555555555555p-5 + s * -0x1.6c16c16c16c17p-10));
    }

    double sine_rest, cosine_less_1;
};

/// The angle of the vector (x, y) from the x axis, in [-pi, pi] or [-180, 180]: to 2^-103 of itself, or, from doubles,
/// to 2^-51 of itself; 0 of (0, 0).
template <class T> [[nodiscard]] DoubleDouble angle_of(T x, T y, AngleUnit unit) noexcept;
/// The same in radians of x >= 0 and y >= 2^-100, neither below 2^-400 but 0: not normalised.
[[nodiscard]] DoubleDouble acute_angle(double x, double y) noexcept;
[[nodiscard]] inline Wide angle_of(const Wide& x, const Wide& y, AngleUnit unit) noexcept {
    return Wide::angle_of(x, y, unit == AngleUnit::degrees);
}
/// Those of a batch of rows, of components that are 0 or between 2^-950 and 2^400. From Approximate, which must be
/// normalized(), to 2^-65 of itself.
template <class T> void angles_of(const Column<T>& x, const Column<T>& y, std::size_t rows, AngleUnit unit,
                                  Column<DoubleDouble>& angles) noexcept;

} // namespace ROTCONV_TARGET
} // namespace rotconv
