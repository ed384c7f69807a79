#include "axis_half_angle.hpp"
#include "codec.hpp"
#include "scaling.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

template <class T>
void read(const Spec& /*spec*/, const double* numbers, std::size_t rows, BasicReadings<T>& readings) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double* const own = numbers + 3 * i;
        const bool finite = all_finite(own[0], own[1], own[2]);
        readings.error[i] = finite ? Error::none : Error::not_finite;
        readings.defect[i] = 0.0;
        const double size = finite ? largest_magnitude(own[0], own[1], own[2]) : 0.0;
        // (1 - |m|^2, 2 m) times the square of a power of two f <= 1, so that |m|^2 cannot overflow
        const double f = scale_to_unit(larger_of(0.5, size)).there;
        const double rest = scale_to_unit(larger_of(0.5, size * f)).there;
        const double x = finite ? own[0] * f * rest : 0.0;
        const double y = finite ? own[1] * f * rest : 0.0;
        const double z = finite ? own[2] * f * rest : 0.0;
        const double one = f * rest;
        const Real square = sum_of_squares(x, y, z);
        const double norm = one * one + square.hi;
        const double to_range = norm < 0.5 ? 2.0 : (norm >= 2.0 ? 0.5 : 1.0);
        const double twice = 2.0 * one * to_range;
        readings.set(i, rounded_to<T>(scaled(one * one - square, to_range)), x * twice, y * twice, z * twice);
    }
}

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    AxisHalfAngles<T> parts;
    parts.take_apart(rotations, rows);
    for (std::size_t i = 0; i < rows; ++i) {
        const Real norm = root(quick_sum(exact_square(parts.w[i]), square(scaled(parts.length[i], parts.back[i]))));
        const Real inverse = 1.0 / quick_sum(norm, parts.w[i]);
        numbers[3 * i] = (parts.x[i] * inverse).hi * parts.back[i];
        numbers[3 * i + 1] = (parts.y[i] * inverse).hi * parts.back[i];
        numbers[3 * i + 2] = (parts.z[i] * inverse).hi * parts.back[i];
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = {DiagnosticKind::half_turn, is_half_turn(parts.w.hi[i], parts.length.hi[i], parts.back[i])};
    }
}

} // namespace

constinit const BatchCodec batch_codecs::mrp{.fast = {.read = read<double>, .write = write<double>},
                                             .exact = {.read = read<Real>, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
