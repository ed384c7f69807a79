#include "../numerics/power_of_two.hpp"
#include "axis_half_angle.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// A rotation vector times a power of two, its largest component of size 1/2 to 1, and its length; the zero vector as
/// it is.
template <class T> struct UnitVector {
    ROTCONV_INLINE UnitVector() noexcept = default;
    ROTCONV_INLINE UnitVector(double x_, double y_, double z_) noexcept {
        const double size = largest_magnitude(x_, y_, z_);
        const double scale = unit_scale(is_plain_number(size) && size > 0.0 ? size : 0.5);
        x = x_ * scale;
        y = y_ * scale;
        z = z_ * scale;
        length = root(sum_of_squares(x, y, z));
        back = 1.0 / scale;
    }

    Given<T> x, y, z;
    Precise<T> length;
    double back; ///< times this, it is the vector
};

/// (|v| cos, v sin) of the half angle; of no turn the identity.
template <class T>
ROTCONV_INLINE void quaternion_of(const UnitVector<T>& v, const SineCosine<T>& half, T (&q)[4]) noexcept {
    q[0] = select(sign_of(v.length) == 0.0, T(1.0), narrowed<T>(v.length * half.cosine));
    q[1] = half.sine * v.x;
    q[2] = half.sine * v.y;
    q[3] = half.sine * v.z;
}

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    double vectors[3][batch_rows];
    Column<DoubleDouble> length;
    Column<DoubleDouble> half;
    Column<T> cosine;
    Column<T> sine;
    for (std::size_t i = 0; i < rows; ++i) {
        attitudes.error[i] = all_finite(numbers + 3 * i, 3) ? Error::none : Error::not_finite;
        attitudes.defect[i] = 0.0;
    }
    to_columns(numbers, rows, vectors);
    for (std::size_t i = 0; i < rows; ++i) {
        const UnitVector<T> v(vectors[0][i], vectors[1][i], vectors[2][i]);
        vectors[0][i] = v.x;
        vectors[1][i] = v.y;
        vectors[2][i] = v.z;
        length.set(i, v.length);
        half.set(i, scaled(v.length, 0.5 * v.back));
    }
    sine_cosine(half, rows, spec.unit, cosine, sine);
    for (std::size_t i = 0; i < rows; ++i) {
        UnitVector<T> v;
        v.x = vectors[0][i];
        v.y = vectors[1][i];
        v.z = vectors[2][i];
        v.length = length[i];
        T q[4];
        quaternion_of(v, SineCosine<T>{sine[i], cosine[i]}, q);
        attitudes.set(i, q);
    }
}

Error read_one(const Spec& spec, const double* numbers, double* q, double& defect) noexcept {
    defect = 0.0;
    if (!all_finite(numbers, 3)) {
        return Error::not_finite;
    }
    const UnitVector<double> v(numbers[0], numbers[1], numbers[2]);
    double own[4];
    quaternion_of(v, sine_cosine<double>(scaled(v.length, 0.5 * v.back), spec.unit), own);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = own[k];
    }
    return Error::none;
}

void read_carefully(const Spec& spec, const double* numbers, ScaledDoubleDouble* q) noexcept {
    UnitVector<ScaledDoubleDouble> v;
    v.x = numbers[0];
    v.y = numbers[1];
    v.z = numbers[2];
    v.length = root(sum_of_squares(v.x, v.y, v.z));
    ScaledDoubleDouble own[4];
    quaternion_of(v, sine_cosine(v.length.shifted(-1), spec.unit), own);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = own[k];
    }
}

/// n angle; of no angle 0.
template <class T> ROTCONV_INLINE void numbers_of(const AxisHalfAngle<T>& parts, const Precise<T>& angle,
                                                  Precise<T> (&numbers)[3]) noexcept {
    const Precise<T> ratio = angle / select(sign_of(parts.length) == 0.0, Precise<T>(1.0), parts.length);
    numbers[0] = ratio * parts.x;
    numbers[1] = ratio * parts.y;
    numbers[2] = ratio * parts.z;
}

template <class T> void write(const Spec& spec, double /*lock_margin*/, const AttitudeBatch<T>& attitudes,
                              std::size_t rows, double* numbers, double* rest, DiagnosticSet* diagnostics) noexcept {
    const AxisHalfAngles<T> parts(attitudes, rows);
    Column<DoubleDouble> angle;
    parts.find_angles(rows, spec.unit, angle);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble result[3];
        numbers_of(parts[i], angle[i], result);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[3 * i + k] = result[k].hi;
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = parts[i].diagnostics();
    }
    for (std::size_t i = 0; i < rows && rest != nullptr; ++i) {
        DoubleDouble result[3];
        numbers_of(parts[i], angle[i], result);
        for (std::size_t k = 0; k < 3; ++k) {
            rest[3 * i + k] = result[k].lo;
        }
    }
}

template <class T> DiagnosticSet write_row(const Spec& spec, double /*lock_margin*/, const T* q, T* numbers) noexcept {
    const AxisHalfAngle<T> parts({q[0], q[1], q[2], q[3]});
    Precise<T> result[3];
    numbers_of(parts, parts.angle(spec.unit), result);
    for (std::size_t k = 0; k < 3; ++k) {
        numbers[k] = narrowed<T>(result[k]);
    }
    return parts.diagnostics();
}

} // namespace

constinit const Kernel kernels::rotvec{.fast = {.read = read<double>, .write = write<double>},
                                       .exact = {.read = read<DoubleDouble>, .write = write<DoubleDouble>},
                                       .one = {.read = read_one, .write = write_row<double>},
                                       .careful = {.read = read_carefully, .write = write_row<ScaledDoubleDouble>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
