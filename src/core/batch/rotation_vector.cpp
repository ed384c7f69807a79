#include "rotation_vector.hpp"

#include "axis_half_angle.hpp"
#include "codec.hpp"

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
        const ScaledRotationVector v(x[i], y[i], z[i]);
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
        back[i] = v.back;
        length.set(i, v.length);
        half.set(i, v.half_angle());
    }
    sine_cosine(half, rows, unit, cosine, sine);
    const Real half_unit = half_unit_in_radians(unit);
    for (std::size_t i = 0; i < rows; ++i) {
        ScaledRotationVector v;
        v.x = x[i];
        v.y = y[i];
        v.z = z[i];
        v.back = back[i];
        v.length = length[i];
        T q[4];
        quaternion_of(v, SineCosine<T>{sine[i], cosine[i]}, half_unit, q);
        readings.set(i, q);
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

Error read_one(const Spec& spec, const double* numbers, double* q) noexcept {
    if (!all_finite(numbers[0], numbers[1], numbers[2])) {
        return Error::not_finite;
    }
    const ScaledRotationVector v(numbers[0], numbers[1], numbers[2]);
    double own[4];
    quaternion_of(v, sine_cosine<double>(v.half_angle(), spec.unit), half_unit_in_radians(spec.unit), own);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = own[k];
    }
    return Error::none;
}

} // namespace

constinit const BatchCodec batch_codecs::rotvec{.fast = {.read = read<double>, .write = write<double>},
                                                .exact = {.read = read<Real>, .write = write<Real>},
                                                .one = {.read = read_one}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
