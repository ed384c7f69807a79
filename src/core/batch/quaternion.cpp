#include "codec.hpp"
#include "matrix.hpp"
#include "rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Unit {
    static constexpr std::size_t size = 4;

    template <class T> ROTCONV_INLINE static T norm_of(const T& square) noexcept { return root(square); }
    /// Keeps the bits of what is unit to 4 eps.
    ROTCONV_INLINE static double norm_of(double square) noexcept {
        return __builtin_fabs(square - 1.0) <= 4.0 * 0x1p-52 ? 1.0 : root(square);
    }

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[4]) noexcept {
        for (std::size_t k = 0; k < 4; ++k) {
            numbers[k] = q[k];
        }
        divide(numbers, norm_of(squared_norm(q)));
    }
};

/// Doubles with | |q| - 1 | <= 4 eps.
bool is_unit(const Real (&own)[4]) noexcept {
    if (own[0].lo != 0.0 || own[1].lo != 0.0 || own[2].lo != 0.0 || own[3].lo != 0.0) {
        return false; // turned by something else than a quarter
    }
    const double excess = (squared_norm(own) - 1.0).hi;
    constexpr double rounding = 4 * 0x1p-52;
    return __builtin_fabs(excess - rounding * rounding) <= 2.0 * rounding;
}

void read(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<Real>& readings) noexcept {
    read_plain(spec, numbers, rows, readings); // rounds nothing
    readings.as_given = true;
}

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<Unit>(rotations, rows, numbers);
    for (std::size_t i = 0; i < rows; ++i) {
        double* const q = numbers + 4 * i;
        if constexpr (std::is_same_v<T, Real>) {
            if (rotations.as_given) {
                Real given[4];
                rotations.get(i, given);
                if (is_unit(given)) {
                    for (std::size_t k = 0; k < 4; ++k) {
                        q[k] = given[k].hi;
                    }
                }
            }
        }
        const double sign = printed_sign(q[0], q[1], q[2], q[3]);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] *= sign;
        }
    }
}

} // namespace

constinit const BatchCodec batch_codecs::quat{.fast = {.read = nullptr, .write = write<double>},
                                              .exact = {.read = read, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
