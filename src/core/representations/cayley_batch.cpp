#include "../numerics/power_of_two.hpp"
#include "kernel.hpp"
#include "write_rows.hpp"

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

/// (1, c), times a power of two.
Error read_one(const Spec& /*spec*/, const double* numbers, double* q, double& defect) noexcept {
    defect = 0.0;
    const double largest = largest_magnitude(1.0, numbers[0], numbers[1], numbers[2]);
    if (!(largest < 0x1p1000)) [[unlikely]] {
        const PowerOfTwo scale = PowerOfTwo::to_unit(largest);
        q[0] = scale(1.0);
        for (std::size_t k = 0; k < 3; ++k) {
            q[k + 1] = scale(numbers[k]);
        }
        return all_finite(numbers, 3) ? Error::none : Error::not_finite;
    }
    const double scale = unit_scale(largest);
    q[0] = scale;
    for (std::size_t k = 0; k < 3; ++k) {
        q[k + 1] = numbers[k] * scale;
    }
    return all_finite(numbers, 3) ? Error::none : Error::not_finite;
}

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        double q[4];
        attitudes.error[i] = read_one(spec, numbers + 3 * i, q, attitudes.defect[i]);
        attitudes.set(i, q[0], q[1], q[2], q[3]);
    }
}

void read_carefully(const Spec& /*spec*/, const double* numbers, ScaledDoubleDouble* q) noexcept {
    q[0] = 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
        q[k + 1] = numbers[k];
    }
}

/// Infinite with the sign of each component that is not 0, where a quotient is; else 0.
DiagnosticSet replace_infinite(const double (&q)[4], double* c) noexcept {
    if (all_finite(c, 3)) [[likely]] {
        return {};
    }
    const double sign = canonical_sign(q[0], q[1], q[2], q[3]);
    for (std::size_t k = 0; k < 3; ++k) {
        c[k] = q[k + 1] == 0.0 ? 0.0 : __builtin_copysign(__builtin_inf(), sign * q[k + 1]);
    }
    return {DiagnosticKind::infinite, true};
}

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const AttitudeBatch<T>& attitudes,
                              std::size_t rows, double* numbers, double* /*rest*/,
                              DiagnosticSet* diagnostics) noexcept {
    write_rows<Quotients>(attitudes, rows, numbers);
    for (std::size_t i = 0; i < rows; ++i) {
        diagnostics[i] = replace_infinite({attitudes.w.hi[i], attitudes.x.hi[i], attitudes.y.hi[i], attitudes.z.hi[i]},
                                          numbers + 3 * i);
    }
}

DiagnosticSet write_one(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept {
    write_row_by<Quotients, double>(spec, lock_margin, q, numbers);
    return replace_infinite({q[0], q[1], q[2], q[3]}, numbers);
}

DiagnosticSet write_carefully(const Spec& spec, double lock_margin, const ScaledDoubleDouble* q,
                              ScaledDoubleDouble* numbers) noexcept {
    write_row_by<Quotients, ScaledDoubleDouble>(spec, lock_margin, q, numbers);
    double rounded[3] = {numbers[0].rounded(), numbers[1].rounded(), numbers[2].rounded()};
    const DiagnosticSet found = replace_infinite({sign_of(q[0]), sign_of(q[1]), sign_of(q[2]), sign_of(q[3])}, rounded);
    for (std::size_t k = 0; k < 3 && !found.empty(); ++k) {
        numbers[k] = rounded[k];
    }
    return found;
}

} // namespace

constinit const Kernel kernels::cayley{.fast = {.read = read<double>, .write = write<double>},
                                       .exact = {.read = read<DoubleDouble>, .write = write<DoubleDouble>},
                                       .one = {.read = read_one, .write = write_one},
                                       .careful = {.read = read_carefully, .write = write_carefully},
                                       .reading_is_exact = true};

} // namespace ROTCONV_TARGET
} // namespace rotconv
