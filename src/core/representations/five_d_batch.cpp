#include "columns_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct FiveNumbers : ReadByColumns<FiveNumbers, 5>, WrittenByFormula<FiveNumbers, 5> {
    /// Entries of the matrix over a divisor of 0.41 to 2.42 |q|^2.
    ROTCONV_INLINE static ErrorBound error_of(const double (&/*q*/)[4], double off) noexcept {
        const ErrorBound error = error_of_entries(off);
        return {8.0 * error.absolute, error.relative};
    }
    /// sqrt 2 + sign.
    template <class T> ROTCONV_INLINE static T constant(double sign) noexcept {
        if constexpr (std::is_same_v<T, Wide>) {
            return root(Wide(2.0)) + Wide(sign);
        } else {
            return rounded_to<T>(sign < 0.0 ? DoubleDouble(0x1.a827999fcef32p-2, 0x1.08b2fb1366ea9p-56)
                                            : DoubleDouble(0x1.3504f333f9de6p+1, 0x1.21165f626cdd5p-53));
        }
    }
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&numbers)[5]) noexcept {
        T m[9];
        scaled_matrix_of(q, m);
        const T turning = sloppy_sum(square(q[0]), square(q[1]));
        const T tilting = sloppy_sum(square(q[2]), square(q[3]));
        numbers[0] = m[3];
        numbers[1] = m[6];
        numbers[2] = m[1];
        numbers[3] = m[4];
        numbers[4] = m[7];
        // sqrt 2 - r11, without cancellation
        divide(numbers, sloppy_sum(turning * constant<T>(-1.0), tilting * constant<T>(1.0)));
    }

    /// Parallel to Hopf's columns.
    template <class T> ROTCONV_INLINE static void directions(const T (&y)[5], T (&first)[3], T (&second)[3]) noexcept {
        const T sum = ((square(y[0]) + square(y[1])) + (square(y[2]) + square(y[3]))) + square(y[4]);
        first[0] = sum - T(1.0);
        first[1] = scaled(y[0], 2.0);
        first[2] = scaled(y[1], 2.0);
        load(y + 2, second);
    }
    static unsigned sign_of_r11(const double* y) noexcept {
        double square = 0.0;
        for (std::size_t k = 0; k < size; ++k) {
            square += y[k] * y[k];
        }
        return square > 1.0 ? 1U : 0U;
    }
    /// The terms of the first one's first number beside its length, of which it is off by a part.
    ROTCONV_INLINE static double lost_by_directions(const double (&y)[5]) noexcept {
        const double sum = ((y[0] * y[0] + y[1] * y[1]) + (y[2] * y[2] + y[3] * y[3])) + y[4] * y[4];
        const double rest = sum - 1.0;
        return (sum + 1.0) / root(rest * rest + 4.0 * (y[0] * y[0] + y[1] * y[1]));
    }
    /// The two columns, from numbers of any size.
    ROTCONV_INLINE static void columns(const double (&y)[5], double (&m)[6]) noexcept {
        const double largest = largest_magnitude(y[0], y[1], y[2], y[3], y[4]);
        const double f = largest < 0x1p500 ? 1.0 : 0x1p-600; // f^2 (y'y + 1) does not overflow
        const double s[5] = {f * y[0], f * y[1], f * y[2], f * y[3], f * y[4]};
        const double squares = ((s[0] * s[0] + s[1] * s[1]) + (s[2] * s[2] + s[3] * s[3])) + s[4] * s[4];
        const double factor = 1.4142135623730951 / (squares + f * f);
        m[0] = factor * (squares - f * f);
        for (std::size_t k = 0; k < 5; ++k) {
            m[k + 1] = (2.0 * f) * (factor * s[k]);
        }
    }
};

} // namespace

constinit const Kernel kernels::five_d = []() noexcept {
    Kernel kernel = kernel_of_formula<FiveNumbers>;
    kernel.column = FiveNumbers::size;
    kernel.hidden_sign = FiveNumbers::sign_of_r11;
    return kernel;
}();

} // namespace ROTCONV_TARGET
} // namespace rotconv
