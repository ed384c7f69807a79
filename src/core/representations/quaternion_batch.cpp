#include "../numerics/power_of_two.hpp"
#include "kernel.hpp"
#include "write_rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Unit {
    static constexpr std::size_t size = 4;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[4]) noexcept {
        for (std::size_t k = 0; k < 4; ++k) {
            numbers[k] = q[k];
        }
        divide(numbers, root(squared_norm(q)));
        const double sign = canonical_sign(sign_of(q[0]), sign_of(q[1]), sign_of(q[2]), sign_of(q[3]));
        for (T& number : numbers) {
            number = scaled(number, sign);
        }
    }
};

/// Any four numbers; finds the defect | |q| - 1 | in full.
Error read_one(const Spec& /*spec*/, const double* numbers, double* q, double& defect) noexcept {
    double largest = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = numbers[k];
        largest = larger_of(largest, __builtin_fabs(numbers[k]));
    }
    if (!all_finite(numbers, 4)) {
        return Error::not_finite;
    }
    if (largest == 0.0) {
        return Error::zero_quaternion;
    }
    const double square = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    if (__builtin_fabs(square - 1.0) <= reported_defect) {
        defect = __builtin_fabs(square - 1.0); // | |q| - 1 | (|q| + 1)
        return Error::none;
    }
    const PowerOfTwo to_unit = PowerOfTwo::to_unit(largest);
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = to_unit(numbers[k]);
    }
    defect = __builtin_fabs(to_unit.undone(root((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]))) - 1.0);
    if (square >= 0.25 && square < 4.0) { // its own bits
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = numbers[k];
        }
    }
    return Error::none;
}

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    attitudes.are_quaternions = true;
    for (std::size_t i = 0; i < rows; ++i) {
        const double* const q = numbers + 4 * i;
        const double square = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
        attitudes.set(i, q[0], q[1], q[2], q[3]);
        attitudes.defect[i] = __builtin_fabs(square - 1.0);
        attitudes.error[i] = Error::none;
        attitudes.is_as_given[i] = true;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (!(attitudes.defect[i] <= reported_defect)) {
            double q[4];
            attitudes.error[i] = read_one(spec, numbers + 4 * i, q, attitudes.defect[i]);
            attitudes.is_as_given[i] = false;
            if (attitudes.error[i] == Error::none) {
                attitudes.set(i, q[0], q[1], q[2], q[3]);
            } else {
                attitudes.set(i, 1.0, 0.0, 0.0, 0.0);
            }
        }
    }
}

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const AttitudeBatch<T>& attitudes,
                              std::size_t rows, double* numbers, double* /*rest*/,
                              DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<Unit>(attitudes, rows, numbers);
    for (std::size_t i = 0; i < rows && attitudes.are_quaternions; ++i) {
        if (keeps_bits(attitudes, i)) {
            const double sign =
                canonical_sign(attitudes.w.hi[i], attitudes.x.hi[i], attitudes.y.hi[i], attitudes.z.hi[i]);
            numbers[4 * i] = sign * attitudes.w.hi[i];
            numbers[4 * i + 1] = sign * attitudes.x.hi[i];
            numbers[4 * i + 2] = sign * attitudes.y.hi[i];
            numbers[4 * i + 3] = sign * attitudes.z.hi[i];
        }
    }
}

void read_carefully(const Spec& /*spec*/, const double* numbers, ScaledDoubleDouble* q) noexcept {
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = numbers[k];
    }
}

} // namespace

constinit const Kernel kernels::quat{
    .fast = {.read = read<double>, .write = write<double>},
    .exact = {.read = read<DoubleDouble>, .write = write<DoubleDouble>},
    .one = {.read = read_one, .write = write_row_by<Unit, double>},
    .careful = {.read = read_carefully, .write = write_row_by<Unit, ScaledDoubleDouble>},
    .reading_is_exact = true};

} // namespace ROTCONV_TARGET
} // namespace rotconv
