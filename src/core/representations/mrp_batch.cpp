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
