#include "axis_and_angle.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct RotationVector : ReadByAxis<RotationVector, 3>, WrittenByAxis<RotationVector, 3> {
    static constexpr bool is_exact = false;

    ROTCONV_INLINE static Error error_of(const double* numbers, AngleUnit /*unit*/) noexcept {
        return all_finite(numbers, 3) ? Error::none : Error::not_finite;
    }
    template <class T>
    ROTCONV_INLINE static Precise<T> half_angle(const AxisVector<T>& v, const double* /*numbers*/) noexcept {
        return scaled(v.length, 0.5 * v.back);
    }

    /// v f, with f = 2 atan(|v|/w)/|v| of at most pi/|v|: off by f dv and |v| df, 16 off in all, and by 2^-96 of
    /// itself.
    ROTCONV_INLINE static ErrorBound error_of(std::size_t /*k*/, double /*length*/, AngleUnit unit,
                                              double off) noexcept {
        return {(unit == AngleUnit::degrees ? 64.0 : 1.0) * 32.0 * off, 0x1p-95};
    }

    /// n angle; of no angle 0.
    template <class T> ROTCONV_INLINE static void
    numbers_of(const T (&q)[4], const Precise<T>& length, const Precise<T>& angle, Precise<T> (&numbers)[3]) noexcept {
        const Precise<T> ratio = angle / select(sign_of(length) == 0.0, Precise<T>(1.0), length);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = ratio * q[k + 1];
        }
    }

    // One row in double, with what the roundings of the length and of the ratio have left out.

    static Error read_one(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept {
        const double v[3] = {alone(numbers[0]), alone(numbers[1]), alone(numbers[2])};
        const DoubleDouble length = length_of(v[0], v[1], v[2]);
        if (!(length.hi >= 0x1p-100 && length.hi < 0x1p12)) [[unlikely]] {
            return ReadByAxis::read_one(spec, numbers, q, defect);
        }
        defect = 0.0;
        const SineCosine<double> half = spec.unit == AngleUnit::degrees
                                            ? sine_cosine<double>(scaled(length, 0.5), spec.unit)
                                            : half_sine_cosine(length);
        // A unit quaternion need not be divided by its length.
        const double inverse = 1.0 / length.hi;
        const DoubleDouble one = two_prod(inverse, length.hi);
        const double rest = (((1.0 - one.hi) - one.lo) - inverse * length.lo) * inverse;
        q[0] = half.cosine;
        for (std::size_t k = 0; k < 3; ++k) {
            const DoubleDouble along = two_prod(inverse, v[k]);
            const DoubleDouble product = two_prod(half.sine, along.hi);
            q[k + 1] = product.hi + (product.lo + half.sine * (along.lo + rest * v[k]));
        }
        return Error::none;
    }

    using WrittenByAxis::write_one;
    static DiagnosticSet write_one(const Spec& spec, double lock_margin, const double (&q)[4],
                                   double* numbers) noexcept {
        const DoubleDouble length = length_of(alone(q[1]), alone(q[2]), alone(q[3]));
        if (!(length.hi >= 0x1p-100)) [[unlikely]] {
            return WrittenByAxis::write_one(spec, lock_margin, q, numbers);
        }
        const double w = __builtin_fabs(alone(q[0]));
        const DoubleDouble half = acute_angle(w, length.hi);
        const double inverse = 1.0 / length.hi;
        const double high = half.hi * (2.0 * inverse);
        const DoubleDouble back = two_prod(high, length.hi);
        // d(angle) = d|v| 2 w/|q|^2
        const double beside = length.lo * (2.0 * w / (w * w + length.hi * length.hi) - high);
        const double rest = ((2.0 * half.hi - back.hi) - back.lo) + (2.0 * half.lo + beside);
        const DoubleDouble in_radians{high, rest * inverse};
        const DoubleDouble ratio = spec.unit == AngleUnit::degrees ? in_radians * exact_degrees_per_radian : in_radians;
        const double sign = canonical_sign<double>({alone(q[0]), alone(q[1]), alone(q[2]), alone(q[3])});
        for (std::size_t k = 0; k < 3; ++k) {
            const double component = sign * alone(q[k + 1]);
            const DoubleDouble product = two_prod(ratio.hi, component);
            numbers[k] = product.hi + (product.lo + ratio.lo * component);
        }
        return half_turn_of<double>({w, length.hi, 0.0, 0.0});
    }
};

} // namespace

constinit const Kernel kernels::rotvec = kernel_of_formula<RotationVector>;

} // namespace ROTCONV_TARGET
} // namespace rotconv
