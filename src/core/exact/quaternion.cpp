#include "codec.hpp"
#include "matrix.hpp"
#include "rows.hpp"

namespace rotconv::ROTCONV_EXACT {
namespace {

struct Unit {
    static constexpr std::size_t size = 4;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[4]) noexcept {
        const T inverse = T(1.0) / root(squared_norm(q));
        for (std::size_t k = 0; k < 4; ++k) {
            numbers[k] = q[k] * inverse;
        }
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

void read(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    read_plain(spec, numbers, rows, readings); // rounds nothing
    readings.as_given = true;
}

void write(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows, double* numbers,
           DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<Unit>(rotations, rows, numbers);
    for (std::size_t i = 0; i < rows; ++i) {
        double* const q = numbers + 4 * i;
        if (rotations.as_given) {
            const Real given[4] = {rotations.w[i], rotations.x[i], rotations.y[i], rotations.z[i]};
            if (is_unit(given)) {
                for (std::size_t k = 0; k < 4; ++k) {
                    q[k] = given[k].hi;
                }
            }
        }
        const double vector_leader = q[1] != 0.0 ? q[1] : (q[2] != 0.0 ? q[2] : q[3]);
        const double sign = (q[0] != 0.0 ? q[0] : vector_leader) < 0.0 ? -1.0 : 1.0;
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] *= sign;
        }
    }
}

} // namespace

constinit const ExactCodec codecs::quat{.read = read, .write = write};

} // namespace rotconv::ROTCONV_EXACT
