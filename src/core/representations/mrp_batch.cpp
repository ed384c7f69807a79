#include "axis_and_angle.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Mrp {
    static constexpr std::size_t size = 3;

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
    template <class T>
    ROTCONV_INLINE static void numbers_of(const T (&q)[4], const Precise<T>& length, Precise<T> (&m)[3]) noexcept {
        const Precise<T> w = q[0];
        const Precise<T> norm = root(sloppy_sum(square(w), square(length)));
        const Precise<T> inverse = Precise<T>(1.0) / sloppy_sum(norm, w);
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = inverse * q[k + 1];
        }
    }
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&m)[3]) noexcept {
        const AxisHalfAngle<T> part(q);
        Precise<T> result[3];
        numbers_of(part.q, part.length, result);
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = rounded_to<T>(result[k]);
        }
    }
    template <class T> ROTCONV_INLINE static DiagnosticSet complete(const T (&q)[4], double* /*m*/) noexcept {
        return half_turn_of(q);
    }

    /// In several loops, which are faster than one.
    template <class T> static void write(const Spec& /*spec*/, double /*lock_margin*/,
                                         const AttitudeBatch<T>& attitudes, std::size_t rows, double* numbers,
                                         double* rest, DiagnosticSet* diagnostics) noexcept {
        Columns<T, 4> parts;
        Column<DoubleDouble> length;
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            attitudes.get(i, q);
            const AxisHalfAngle<T> part(q);
            parts.set(i, part.q);
            length.set(i, part.length);
        }
        const auto result_of = [&](std::size_t i, DoubleDouble(&m)[3]) {
            T q[4];
            parts.get(i, q);
            numbers_of(q, length[i], m);
        };
        write_results<3>(rows, result_of, numbers, rest);
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            parts.get(i, q);
            diagnostics[i] = half_turn_of(q);
        }
    }
};

constexpr Kernel kernel_of_mrp() noexcept {
    Kernel made = kernel_of_formula<Mrp>;
    made.fast.write = Mrp::write<double>;
    made.exact.write = Mrp::write<DoubleDouble>;
    return made;
}

} // namespace

constinit const Kernel kernels::mrp = kernel_of_mrp();

} // namespace ROTCONV_TARGET
} // namespace rotconv
