#include "axis_and_angle.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct AxisAngle : ReadByAxis<AxisAngle, 4>, WrittenByAxis<AxisAngle, 4> {
    static constexpr bool is_exact = true;

    /// Whether the numbers are finite and have an axis, or need none: the turn is 0, or in degrees whole turns.
    ROTCONV_INLINE static Error error_of(const double* v, AngleUnit unit) noexcept {
        if (!all_finite(v, 4)) {
            return Error::not_finite;
        }
        if (largest_magnitude(v[0], v[1], v[2]) > 0.0 || v[3] == 0.0) {
            return Error::none;
        }
        const bool is_whole_turn = unit == AngleUnit::degrees && sine_cosine<double>(0.5 * v[3], unit).sine == 0.0;
        return is_whole_turn ? Error::none : Error::zero_axis;
    }
    template <class T>
    ROTCONV_INLINE static Precise<T> half_angle(const AxisVector<T>& /*v*/, const double* numbers) noexcept {
        return scaled(Precise<T>(numbers[3]), 0.5);
    }

    /// The axis is off by 2 dv/|v|, the angle by 2 (dv + dw)/|q| in its unit, both by 2^-96 of themselves.
    ROTCONV_INLINE static ErrorBound error_of(std::size_t k, double length, AngleUnit unit, double off) noexcept {
        if (k == 3) {
            return {(unit == AngleUnit::degrees ? 64.0 : 1.0) * 16.0 * off, 0x1p-95};
        }
        return {off == 0.0 ? 0.0 : 8.0 * off / length, 0x1p-95};
    }

    /// The axis is (1, 0, 0) where there is no vector part.
    template <class T> ROTCONV_INLINE static void
    numbers_of(const T (&q)[4], const Precise<T>& length, const Precise<T>& angle, Precise<T> (&numbers)[4]) noexcept {
        const bool is_identity = sign_of(length) == 0.0;
        const Precise<T> one = 1.0;
        const Precise<T> inverse = one / select(is_identity, one, length);
        numbers[0] = select(is_identity, one, inverse * q[1]);
        numbers[1] = inverse * q[2];
        numbers[2] = inverse * q[3];
        numbers[3] = angle;
    }
    template <class T> ROTCONV_INLINE static DiagnosticSet diagnostics_of(const T (&q)[4]) noexcept {
        DiagnosticSet found = half_turn_of(q);
        const bool is_identity = sign_of(q[1]) == 0.0 && sign_of(q[2]) == 0.0 && sign_of(q[3]) == 0.0;
        found |= {DiagnosticKind::identity_axis, is_identity};
        return found;
    }
};

} // namespace

constinit const Kernel kernels::axis_angle = kernel_of_formula<AxisAngle>;

} // namespace ROTCONV_TARGET
} // namespace rotconv
