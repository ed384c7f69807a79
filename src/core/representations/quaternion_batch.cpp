#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct FourNumbers : WrittenByFormula<FourNumbers, 4> {
    /// Off by (dq + |n| d|q|)/|q|, and by 2^-96 of itself.
    ROTCONV_INLINE static ErrorBound error_of(const double (&/*q*/)[4], double off) noexcept {
        return {8.0 * off, 0x1p-95};
    }
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&numbers)[4]) noexcept {
        load(q, numbers);
        divide(numbers, root(squared_norm(q)));
        const double sign = canonical_sign(q);
        for (T& number : numbers) {
            number = scaled(number, sign);
        }
    }

    /// Any four numbers; finds the defect | |q| - 1 | in full.
    static Error read_one(const Spec& /*spec*/, const double* numbers, double (&q)[4], double& defect) noexcept {
        load(numbers, q);
        if (!all_finite(numbers, 4)) {
            return Error::not_finite;
        }
        const double largest = largest_magnitude(q[0], q[1], q[2], q[3]);
        if (largest == 0.0) {
            return Error::zero_quaternion;
        }
        const double square = squared_norm(q);
        if (__builtin_fabs(square - 1.0) <= reported_defect) {
            defect = __builtin_fabs(square - 1.0); // | |q| - 1 | (|q| + 1)
            return Error::none;
        }
        const PowerOfTwo to_unit = PowerOfTwo::to_unit(largest);
        const double unit[4] = {to_unit(q[0]), to_unit(q[1]), to_unit(q[2]), to_unit(q[3])};
        defect = __builtin_fabs(to_unit.undone(root(squared_norm(unit))) - 1.0);
        const bool keeps_bits = square >= 0.25 && square < 4.0;
        for (std::size_t k = 0; k < 4 && !keeps_bits; ++k) {
            q[k] = unit[k] == 0.0 && q[k] != 0.0 ? __builtin_copysign(0x1p-1074, q[k]) : unit[k]; // not 0, nor plain
        }
        return Error::none;
    }

    template <class T>
    static void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
        attitudes.are_quaternions = true;
        for (std::size_t i = 0; i < rows; ++i) {
            const double* const q = numbers + 4 * i;
            attitudes.set(i, {q[0], q[1], q[2], q[3]});
            attitudes.defect[i] = __builtin_fabs(squared_norm({q[0], q[1], q[2], q[3]}) - 1.0);
            attitudes.error[i] = Error::none;
            attitudes.off[i] = 0.0;
            attitudes.is_as_given[i] = true;
        }
        for (std::size_t i = 0; i < rows; ++i) {
            if (!(attitudes.defect[i] <= reported_defect)) {
                double q[4];
                attitudes.error[i] = read_one(spec, numbers + 4 * i, q, attitudes.defect[i]);
                attitudes.is_as_given[i] = false;
                attitudes.set(i, {q[0], q[1], q[2], q[3]});
            }
        }
    }

    template <class T> static void write(const Spec& spec, double lock_margin, const AttitudeBatch<T>& attitudes,
                                         std::size_t rows, double* numbers, double* rest, DiagnosticSet* diagnostics,
                                         std::uint64_t* doubts) noexcept {
        WrittenByFormula::write(spec, lock_margin, attitudes, rows, numbers, rest, diagnostics, doubts);
        for (std::size_t i = 0; i < rows && attitudes.are_quaternions; ++i) {
            if (keeps_bits(attitudes, i)) {
                T q[4];
                attitudes.get(i, q);
                for (std::size_t k = 0; k < 4; ++k) {
                    numbers[4 * i + k] = canonical_sign(q) * to_double(q[k]);
                }
                doubts[i] = 0;
            }
        }
    }

    static void read_carefully(const Spec& /*spec*/, const double* numbers, Careful (&q)[4]) noexcept {
        load(numbers, q);
    }
};

} // namespace

constinit const Kernel kernels::quat = []() noexcept {
    Kernel kernel = kernel_of_formula<FourNumbers>;
    kernel.is_quaternion = true;
    return kernel;
}();

} // namespace ROTCONV_TARGET
} // namespace rotconv
