#include "axis_and_angle.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Mrp : ReadByFormula<Mrp>, WrittenByAxis<Mrp, 3> {
    static constexpr bool needs_angle = false;

    /// (1 - |m|^2, 2 m).
    template <class T> ROTCONV_INLINE static void quaternion_of(const double* m, T (&q)[4]) noexcept {
        const Precise<T> square = sum_of_squares(T(m[0]), T(m[1]), T(m[2]));
        q[0] = rounded_to<T>(Precise<T>(1.0) - square);
        for (std::size_t k = 0; k < 3; ++k) {
            q[k + 1] = scaled(T(m[k]), 2.0);
        }
    }
    ROTCONV_INLINE static double size_of(const double* m) noexcept {
        return 1.0 + ((m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]);
    }

    /// 1 - |m|^2 is off by 2^-102 of its larger term, and by 2^-99 of itself unless much cancels.
    ROTCONV_INLINE static double off_of(const double* m) noexcept {
        const double square = (m[0] * m[0] + m[1] * m[1]) + m[2] * m[2];
        return square > 0.875 && square < 1.25 ? 0x1p-101 : 0.0;
    }

    /// m is at most 1, and its divisor at least 1/2: off by 2 dv + 2 |m| (d|q| + dw) <= 8 off, and by 2^-96 of itself.
    ROTCONV_INLINE static ErrorBound error_of(std::size_t /*k*/, double /*length*/, AngleUnit /*unit*/,
                                              double off) noexcept {
        return {16.0 * off, 0x1p-95};
    }
    /// v/(|q| + w), of the q that is printed.
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], const Precise<T>& length,
                                                             const Precise<T>& /*angle*/, Precise<T> (&m)[3]) noexcept {
        const Precise<T> w = q[0];
        const Precise<T> norm = root(sloppy_sum(square(w), square(length)));
        const Precise<T> inverse = Precise<T>(1.0) / sloppy_sum(norm, w);
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = inverse * q[k + 1];
        }
    }
};

} // namespace

constinit const Kernel kernels::mrp = kernel_of_formula<Mrp>;

} // namespace ROTCONV_TARGET
} // namespace rotconv
