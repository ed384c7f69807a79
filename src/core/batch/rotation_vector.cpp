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
    double x[batch_rows];
    double y[batch_rows];
    double z[batch_rows];
    double back[batch_rows];
    Column<Real> length;
    Column<Real> half;
    Column<T> cosine;
    Column<T> sine;
    for (std::size_t i = 0; i < rows; ++i) {
        const double own_x = numbers[3 * i];
        const double own_y = numbers[3 * i + 1];
        const double own_z = numbers[3 * i + 2];
        const bool finite = all_finite(own_x, own_y, own_z);
        readings.error[i] = finite ? Error::none : Error::not_finite;
        readings.defect[i] = 0.0;
        x[i] = finite ? own_x : 0.0;
        y[i] = finite ? own_y : 0.0;
        z[i] = finite ? own_z : 0.0;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const Scale scale = scale_to_unit(largest_magnitude(x[i], y[i], z[i]));
        x[i] *= scale.there;
        y[i] *= scale.there;
        z[i] *= scale.there;
        back[i] = scale.back;
        length.set(i, root(sum_of_squares(x[i], y[i], z[i])));
        half.set(i, scaled(length[i], 0.5 * back[i]));
    }
    sine_cosine(half, rows, unit, cosine, sine);
    const Real half_unit = unit == AngleUnit::degrees ? scaled(exact_radians_per_degree, 0.5) : Real(0.5);
    for (std::size_t i = 0; i < rows; ++i) {
        // of very small vectors sin(x) = x; their products are kept away from underflow
        const bool tiny = back[i] < 0x1p-200;
        const Real ratio = choose(tiny, half_unit, sine[i] / choose(tiny, Real(1.0), length[i]));
        const double factor = tiny ? back[i] : 1.0;
        readings.set(i, cosine[i], rounded_to<T>(scaled(ratio * x[i], factor)),
                     rounded_to<T>(scaled(ratio * y[i], factor)), rounded_to<T>(scaled(ratio * z[i], factor)));
    }
}

template <class T> void write(const Spec& spec, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    AxisHalfAngles<T> parts;
    parts.take_apart(rotations, rows);
    parts.find_angles(rows, spec.unit);
    for (std::size_t i = 0; i < rows; ++i) {
        const Real ratio = parts.angle[i] / choose(parts.length.hi[i] == 0.0, Real(1.0), parts.length[i]);
        numbers[3 * i] = (ratio * parts.x[i]).hi * parts.angle_back[i];
        numbers[3 * i + 1] = (ratio * parts.y[i]).hi * parts.angle_back[i];
        numbers[3 * i + 2] = (ratio * parts.z[i]).hi * parts.angle_back[i];
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = {DiagnosticKind::half_turn, is_half_turn(parts.w.hi[i], parts.length.hi[i], parts.back[i])};
    }
}

} // namespace

constinit const BatchCodec batch_codecs::rotvec{.fast = {.read = read<double>, .write = write<double>},
                                                .exact = {.read = read<Real>, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
