#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Cayley : ReadByFormula<Cayley>, WrittenByFormula<Cayley, 3> {
    /// (1, c).
    template <class T> ROTCONV_INLINE static void quaternion_of(const double* c, T (&q)[4]) noexcept {
        q[0] = 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            q[k + 1] = c[k];
        }
    }
    ROTCONV_INLINE static double size_of(const double* c) noexcept { return largest_magnitude(1.0, c[0], c[1], c[2]); }

    ROTCONV_INLINE static double off_of(const double* /*c*/) noexcept { return 0.0; }

    /// c = v/w is off by (dv + |c| dw)/|w|, and by 2^-96 of itself.
    ROTCONV_INLINE static ErrorBound error_of(const double (&q)[4], double off) noexcept {
        const double ratio = off == 0.0 ? 0.0 : 2.0 * off / __builtin_fabs(q[0]);
        return {ratio, ratio + 0x1p-95};
    }
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&c)[3]) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = q[k + 1];
        }
        divide(c, q[0]);
    }
    /// Infinite with the sign of each component that is not 0, where a quotient is; else 0.
    template <class T, class Number> ROTCONV_INLINE static DiagnosticSet complete(const T (&q)[4], Number* c) noexcept {
        double rounded[3];
        load(c, rounded);
        if (all_finite(rounded, 3)) [[likely]] {
            return {};
        }
        const double sign = canonical_sign(q);
        for (std::size_t k = 0; k < 3; ++k) {
            const double component = sign * sign_of(q[k + 1]);
            c[k] = component == 0.0 ? 0.0 : __builtin_copysign(__builtin_inf(), component);
        }
        return {DiagnosticKind::infinite, true};
    }
};

} // namespace

constinit const Kernel kernels::cayley = kernel_of_formula<Cayley>;

} // namespace ROTCONV_TARGET
} // namespace rotconv
