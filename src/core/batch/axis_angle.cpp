#include "../numerics/elementary.hpp"
#include "axis_half_angle.hpp"
#include "codec.hpp"
#include "scaling.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<T>& readings) noexcept {
    const AngleUnit unit = spec.unit;
    Column<Real> half;
    Column<T> cosine;
    Column<T> sine;
    for (std::size_t i = 0; i < rows; ++i) {
        const double* const own = numbers + 4 * i;
        const bool finite = all_finite(own[0], own[1], own[2]) && all_finite(own[3], 0.0, 0.0);
        readings.error[i] = finite ? Error::none : Error::not_finite;
        readings.defect[i] = 0.0;
        half.set(i, finite ? 0.5 * own[3] : 0.0);
    }
    sine_cosine(half, rows, unit, cosine, sine);
    const Real unit_factor = unit == AngleUnit::degrees ? exact_radians_per_degree : Real(1.0);
    for (std::size_t i = 0; i < rows; ++i) {
        const double* const own = numbers + 4 * i;
        const bool finite = readings.error[i] == Error::none;
        const double size = finite ? largest_magnitude(own[0], own[1], own[2]) : 0.0;
        if (size == 0.0) {
            const bool no_turn = unit == AngleUnit::degrees ? sine.hi[i] == 0.0 : own[3] == 0.0;
            readings.error[i] = finite && !no_turn ? Error::zero_axis : readings.error[i];
            readings.set(i, 1.0, 0.0, 0.0, 0.0);
            continue;
        }
        const Scale scale = scale_to_unit(size);
        // a second one for axes nearer to the ends of the range
        const Scale rest = scale_to_unit(size * scale.there);
        const double x = own[0] * scale.there * rest.there;
        const double y = own[1] * scale.there * rest.there;
        const double z = own[2] * scale.there * rest.there;
        const Real length = root(sum_of_squares(x, y, z));
        // of very small angles sin(x) = x; their products are kept away from underflow
        const bool tiny = __builtin_fabs(half.hi[i]) < 0x1p-200;
        const Real factor = choose(tiny, unit_factor * (0.5 * (own[3] * (tiny ? 0x1p600 : 1.0))), Real(sine[i]));
        const double back = tiny ? 0x1p-600 : 1.0;
        readings.set(i, rounded_to<T>(length * cosine[i]), rounded_to<T>(scaled(factor * x, back)),
                     rounded_to<T>(scaled(factor * y, back)), rounded_to<T>(scaled(factor * z, back)));
    }
}

template <class T> void write(const Spec& spec, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    AxisHalfAngles<T> parts;
    parts.take_apart(rotations, rows);
    parts.find_angles(rows, spec.unit);
    for (std::size_t i = 0; i < rows; ++i) {
        const bool is_identity = parts.length.hi[i] == 0.0;
        const Real inverse = 1.0 / choose(is_identity, Real(1.0), parts.length[i]);
        numbers[4 * i] = is_identity ? 1.0 : (parts.x[i] * inverse).hi;
        numbers[4 * i + 1] = (parts.y[i] * inverse).hi;
        numbers[4 * i + 2] = (parts.z[i] * inverse).hi;
        numbers[4 * i + 3] = parts.angle.hi[i] * parts.angle_back[i];
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = {DiagnosticKind::half_turn, is_half_turn(parts.w.hi[i], parts.length.hi[i], parts.back[i])};
        diagnostics[i] |= {DiagnosticKind::identity_axis, parts.length.hi[i] == 0.0};
    }
}

} // namespace

constinit const BatchCodec batch_codecs::axis_angle{.fast = {.read = read<double>, .write = write<double>},
                                                    .exact = {.read = read<Real>, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
