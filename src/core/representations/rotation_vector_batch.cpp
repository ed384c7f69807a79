#include "axis_and_angle.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct RotationVector {
    static constexpr std::size_t size = 3;

    ROTCONV_INLINE static Error error_of(const double* numbers, AngleUnit /*unit*/) noexcept {
        return all_finite(numbers, 3) ? Error::none : Error::not_finite;
    }
    template <class T>
    ROTCONV_INLINE static Precise<T> half_angle(const AxisVector<T>& v, const double* /*numbers*/) noexcept {
        return scaled(v.length, 0.5 * v.back);
    }

    /// n angle; of no angle 0.
    template <class T> ROTCONV_INLINE static void
    numbers_of(const T (&q)[4], const Precise<T>& length, const Precise<T>& angle, Precise<T> (&numbers)[3]) noexcept {
        const Precise<T> ratio = angle / select(sign_of(length) == 0.0, Precise<T>(1.0), length);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = ratio * q[k + 1];
        }
    }
    template <class T> ROTCONV_INLINE static DiagnosticSet diagnostics_of(const T (&q)[4]) noexcept {
        return half_turn_of(q);
    }
};

} // namespace

constinit const Kernel kernels::rotvec = AxisAndAngle<RotationVector>::kernel;

} // namespace ROTCONV_TARGET
} // namespace rotconv
