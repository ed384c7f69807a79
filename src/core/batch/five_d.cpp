#include "codec.hpp"
#include "columns.hpp"
#include "matrix.hpp"
#include "rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct FiveNumbers {
    static constexpr std::size_t size = 5;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[5]) noexcept {
        // sqrt 2 - 1 and sqrt 2 + 1 to 106 bits and more
        constexpr Real less{0x1.a827999fcef32p-2, 0x1.08b2fb1366ea9p-56};
        constexpr Real more{0x1.3504f333f9de6p+1, 0x1.21165f626cdd5p-53};
        T m[9];
        scaled_matrix_of(q, m);
        const T turning = quick_sum(square(q[0]), square(q[1]));
        const T tilting = quick_sum(square(q[2]), square(q[3]));
        numbers[0] = m[3];
        numbers[1] = m[6];
        numbers[2] = m[1];
        numbers[3] = m[4];
        numbers[4] = m[7];
        // sqrt 2 - r11, without cancellation
        divide(numbers, quick_sum(turning * rounded_to<T>(less), tilting * rounded_to<T>(more)));
    }

    /// Parallel to Hopf's columns.
    template <class T> ROTCONV_INLINE static void directions(const T (&y)[5], T (&first)[3], T (&second)[3]) noexcept {
        const T sum = ((square(y[0]) + square(y[1])) + (square(y[2]) + square(y[3]))) + square(y[4]);
        first[0] = sum - T(1.0);
        first[1] = scaled(y[0], 2.0);
        first[2] = scaled(y[1], 2.0);
        for (std::size_t k = 0; k < 3; ++k) {
            second[k] = y[2 + k];
        }
    }
};

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<FiveNumbers>(rotations, rows, numbers);
}

} // namespace

constinit const BatchCodec batch_codecs::five_d{.fast = {.read = nullptr, .write = write<double>},
                                                .exact = {.read = read_columns<FiveNumbers>, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
