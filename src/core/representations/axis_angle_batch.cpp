#include "../numerics/power_of_two.hpp"
#include "axis_half_angle.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// Whether the numbers are finite and have an axis, or need none: the turn is 0, or in degrees whole turns.
Error error_of(const double* v, AngleUnit unit) noexcept {
    if (!all_finite(v, 4)) {
        return Error::not_finite;
    }
    if (largest_magnitude(v[0], v[1], v[2]) > 0.0 || v[3] == 0.0) {
        return Error::none;
    }
    const bool is_whole_turn = unit == AngleUnit::degrees && sine_cosine<double>(0.5 * v[3], unit).sine == 0.0;
    return is_whole_turn ? Error::none : Error::zero_axis;
}

/// (|n| cos(angle/2), n sin(angle/2)); of no axis the identity.
template <class T>
ROTCONV_INLINE void quaternion_of(const Given<T> (&axis)[3], const SineCosine<T>& half, T (&q)[4]) noexcept {
    const Precise<T> length = root(sum_of_squares(axis[0], axis[1], axis[2]));
    const bool has_axis = sign_of(length) > 0.0;
    q[0] = select(has_axis, narrowed<T>(length * half.cosine), T(1.0));
    for (std::size_t k = 0; k < 3; ++k) {
        q[k + 1] = half.sine * axis[k];
    }
}

/// The axis times a power of two, of length 1/2 to 2.
ROTCONV_INLINE void read_axis(const double* v, double (&axis)[3]) noexcept {
    const double size = largest_magnitude(v[0], v[1], v[2]);
    const double scale = unit_scale(is_plain_number(size) ? size : 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
        axis[k] = v[k] * scale;
    }
}

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    Column<DoubleDouble> half;
    Column<T> cosine;
    Column<T> sine;
    for (std::size_t i = 0; i < rows; ++i) {
        attitudes.error[i] = error_of(numbers + 4 * i, spec.unit);
        attitudes.defect[i] = 0.0;
        half.set(i, attitudes.error[i] == Error::none ? 0.5 * numbers[4 * i + 3] : 0.0);
    }
    sine_cosine(half, rows, spec.unit, cosine, sine);
    for (std::size_t i = 0; i < rows; ++i) {
        double axis[3];
        T q[4];
        read_axis(numbers + 4 * i, axis);
        quaternion_of(axis, SineCosine<T>{sine[i], cosine[i]}, q);
        attitudes.set(i, q);
    }
}

Error read_one(const Spec& spec, const double* numbers, double* q, double& defect) noexcept {
    defect = 0.0;
    const Error error = error_of(numbers, spec.unit);
    if (error == Error::none) {
        double axis[3];
        double own[4];
        read_axis(numbers, axis);
        quaternion_of(axis, sine_cosine<double>(0.5 * numbers[3], spec.unit), own);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = own[k];
        }
    }
    return error;
}

void read_carefully(const Spec& spec, const double* numbers, ScaledDoubleDouble* q) noexcept {
    const ScaledDoubleDouble axis[3] = {numbers[0], numbers[1], numbers[2]};
    ScaledDoubleDouble own[4];
    quaternion_of(axis, sine_cosine(ScaledDoubleDouble(numbers[3]).shifted(-1), spec.unit), own);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = own[k];
    }
}

/// (1, 0, 0) where there is no vector part.
template <class T> ROTCONV_INLINE void axis_of(const AxisHalfAngle<T>& parts, Precise<T> (&axis)[3]) noexcept {
    const bool is_identity = sign_of(parts.length) == 0.0;
    const Precise<T> one = 1.0;
    const Precise<T> inverse = one / select(is_identity, one, parts.length);
    axis[0] = select(is_identity, one, inverse * parts.x);
    axis[1] = inverse * parts.y;
    axis[2] = inverse * parts.z;
}

template <class T> ROTCONV_INLINE DiagnosticSet diagnostics_of(const AxisHalfAngle<T>& parts) noexcept {
    DiagnosticSet found = parts.diagnostics();
    found |= {DiagnosticKind::identity_axis, sign_of(parts.length) == 0.0};
    return found;
}

template <class T> void write(const Spec& spec, double /*lock_margin*/, const AttitudeBatch<T>& attitudes,
                              std::size_t rows, double* numbers, double* rest, DiagnosticSet* diagnostics) noexcept {
    const AxisHalfAngles<T> parts(attitudes, rows);
    Column<DoubleDouble> angle;
    parts.find_angles(rows, spec.unit, angle);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble axis[3];
        axis_of(parts[i], axis);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[4 * i + k] = axis[k].hi;
        }
        numbers[4 * i + 3] = angle.hi[i];
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = diagnostics_of(parts[i]);
    }
    for (std::size_t i = 0; i < rows && rest != nullptr; ++i) {
        rest[4 * i + 3] = angle.lo[i];
    }
}

template <class T> DiagnosticSet write_row(const Spec& spec, double /*lock_margin*/, const T* q, T* numbers) noexcept {
    const AxisHalfAngle<T> parts({q[0], q[1], q[2], q[3]});
    Precise<T> axis[3];
    axis_of(parts, axis);
    for (std::size_t k = 0; k < 3; ++k) {
        numbers[k] = narrowed<T>(axis[k]);
    }
    numbers[3] = narrowed<T>(parts.angle(spec.unit));
    return diagnostics_of(parts);
}

} // namespace

constinit const Kernel kernels::axis_angle{.fast = {.read = read<double>, .write = write<double>},
                                           .exact = {.read = read<DoubleDouble>, .write = write<DoubleDouble>},
                                           .one = {.read = read_one, .write = write_row<double>},
                                           .careful = {.read = read_carefully, .write = write_row<ScaledDoubleDouble>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
