#include "codec.hpp"
#include "rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Quotients {
    static constexpr std::size_t size = 3;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[3]) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = q[k + 1];
        }
        divide(numbers, q[0]);
    }
};

double infinite_along(double component) noexcept {
    return component == 0.0 ? 0.0 : __builtin_copysign(__builtin_inf(), component);
}

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    write_rows<Quotients>(rotations, rows, numbers);
    for (std::size_t i = 0; i < rows; ++i) {
        double* const c = numbers + 3 * i;
        // 0 where all are finite, else nan
        const double infinite = c[0] * 0.0 + c[1] * 0.0 + c[2] * 0.0;
        diagnostics[i] = {DiagnosticKind::infinite, infinite != 0.0};
        if (infinite != 0.0) [[unlikely]] {
            const double q[4] = {rotations.w.hi[i], rotations.x.hi[i], rotations.y.hi[i], rotations.z.hi[i]};
            const double sign = printed_sign(q[0], q[1], q[2], q[3]);
            for (std::size_t k = 0; k < 3; ++k) {
                c[k] = infinite_along(q[k + 1] * sign);
            }
        }
    }
}

} // namespace

// Reading rounds nothing.
constinit const BatchCodec batch_codecs::cayley{.fast = {.read = nullptr, .write = write<double>},
                                                .exact = {.read = nullptr, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
