#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Mrp {
    static constexpr std::size_t size = 3;
    static constexpr bool reading_is_exact = false;

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
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&m)[3]) noexcept {
        const double sign = canonical_sign(q);
        const Precise<T> w = scaled(q[0], sign);
        const Precise<T> length = root(sum_of_squares(q[1], q[2], q[3]));
        const Precise<T> norm = root(sloppy_sum(square(w), square(length)));
        const Precise<T> inverse = scaled(Precise<T>(1.0) / sloppy_sum(norm, w), sign);
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = rounded_to<T>(inverse * q[k + 1]);
        }
    }
    template <class T> ROTCONV_INLINE static DiagnosticSet complete(const T (&q)[4], double* /*m*/) noexcept {
        return half_turn_of(q);
    }
};

} // namespace

constinit const Kernel kernels::mrp = kernel_of_formula<Mrp>;

} // namespace ROTCONV_TARGET
} // namespace rotconv
