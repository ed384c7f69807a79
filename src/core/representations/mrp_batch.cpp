#include "../numerics/power_of_two.hpp"
#include "axis_half_angle.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// (1 - |m|^2, 2 m).
template <class T> ROTCONV_INLINE void quaternion_of(const double* m, T (&q)[4]) noexcept {
    const Precise<T> square = sum_of_squares(T(m[0]), T(m[1]), T(m[2]));
    q[0] = narrowed<T>(Precise<T>(1.0) - square);
    for (std::size_t k = 0; k < 3; ++k) {
        q[k + 1] = scaled(T(m[k]), 2.0);
    }
}

/// The same times a power of two, of length 1/2 to 1.
template <class T> ROTCONV_INLINE Error read_row(const double* m, T (&q)[4]) noexcept {
    const double norm = 1.0 + ((m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]); // the length of (1 - |m|^2, 2 m)
    const double scale = unit_scale(norm < 0x1p1000 ? norm : 1.0);
    quaternion_of(m, q);
    for (T& component : q) {
        component = scaled(component, scale);
    }
    return all_finite(m, 3) ? Error::none : Error::not_finite;
}

template <class T>
void read(const Spec& /*spec*/, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        T q[4];
        attitudes.error[i] = read_row(numbers + 3 * i, q);
        attitudes.defect[i] = 0.0;
        attitudes.set(i, q);
    }
}

Error read_one(const Spec& /*spec*/, const double* numbers, double* q, double& defect) noexcept {
    double own[4];
    const Error error = read_row(numbers, own);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = own[k];
    }
    defect = 0.0;
    return error;
}

void read_carefully(const Spec& /*spec*/, const double* numbers, ScaledDoubleDouble* q) noexcept {
    ScaledDoubleDouble own[4];
    quaternion_of(numbers, own);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = own[k];
    }
}

/// v/(|q| + w).
template <class T> ROTCONV_INLINE void numbers_of(const AxisHalfAngle<T>& parts, Precise<T> (&numbers)[3]) noexcept {
    const Precise<T> w = parts.w;
    const Precise<T> norm = root(sloppy_sum(square(w), square(parts.length)));
    const Precise<T> inverse = Precise<T>(1.0) / sloppy_sum(norm, w);
    numbers[0] = inverse * parts.x;
    numbers[1] = inverse * parts.y;
    numbers[2] = inverse * parts.z;
}

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const AttitudeBatch<T>& attitudes,
                              std::size_t rows, double* numbers, double* /*rest*/,
                              DiagnosticSet* diagnostics) noexcept {
    const AxisHalfAngles<T> parts(attitudes, rows);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble result[3];
        numbers_of(parts[i], result);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[3 * i + k] = result[k].hi;
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = parts[i].diagnostics();
    }
}

template <class T>
DiagnosticSet write_row(const Spec& /*spec*/, double /*lock_margin*/, const T* q, T* numbers) noexcept {
    const AxisHalfAngle<T> parts({q[0], q[1], q[2], q[3]});
    Precise<T> result[3];
    numbers_of(parts, result);
    for (std::size_t k = 0; k < 3; ++k) {
        numbers[k] = narrowed<T>(result[k]);
    }
    return parts.diagnostics();
}

} // namespace

constinit const Kernel kernels::mrp{.fast = {.read = read<double>, .write = write<double>},
                                    .exact = {.read = read<DoubleDouble>, .write = write<DoubleDouble>},
                                    .one = {.read = read_one, .write = write_row<double>},
                                    .careful = {.read = read_carefully, .write = write_row<ScaledDoubleDouble>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
