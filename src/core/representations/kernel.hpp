#pragma once

#include <cstddef>
#include <cstdint>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "../numerics/approximate.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/quaternion_algebra.hpp"
#include "../numerics/wide.hpp"
#include "attitude_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

// Numbers are in the representation's own order, quaternions w, x, y, z and not yet inverted: of a Spec's conventions
// the sequence and the unit are left to kernels.

/// How rows of a representation, at most `batch_rows`, are read and written in a scalar, double or DoubleDouble. What
/// comes of rows that are not plain, see is_plain_number(), is replaced by what CarefulKernel makes of them; their
/// errors and defects count.
template <class T> struct BatchKernel {
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept;
    /// Each number is the result in T, rounded once. `rest`: what the results have beside those numbers, of
    /// representations with a choice (Codec::choose_nearest); may be null. Diagnostics are what there is to report of
    /// each row; the sets are empty at first. Those of doubt_of(), only of DoubleDouble, are added to the doubts;
    /// other_doubt is there where a row is not plain.
    void (*write)(const Spec& spec, double lock_margin, const AttitudeBatch<T>& attitudes, std::size_t rows,
                  double* numbers, double* rest, DiagnosticSet* diagnostics, std::uint64_t* doubts) noexcept;
};

/// One plain row in double.
struct RowKernel {
    Error (*read)(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept;
    DiagnosticSet (*write)(const Spec& spec, double lock_margin, const double (&q)[4], double* numbers) noexcept;
};

using Careful = Wide;

/// One row of numbers of any size.
struct CarefulKernel {
    /// Reads a row in which the other kernels find no error, as a quaternion of any length.
    void (*read)(const Spec& spec, const double* numbers, Careful (&q)[4]) noexcept;
    DiagnosticSet (*write)(const Spec& spec, double lock_margin, const Careful (&q)[4], Careful* numbers) noexcept;
};

/// Calls decides() with more and more bits, until it does, and no sign was in doubt. What the last ones leave within
/// 2^-5000 of 0 or of a tie is one.
template <class Function> void with_enough_bits(const Function& decides) noexcept {
    for (const int bits : {256, 1280, 5120}) {
        const Wide::Bits some(bits);
        if (decides() && !Wide::Bits::doubted()) {
            return;
        }
    }
}

/// A quaternion that was given as such, and is unit to 4 eps, is written with its bits; unless something else than a
/// quarter turn has turned it.
template <class T>
[[nodiscard]] ROTCONV_INLINE bool keeps_bits(const AttitudeBatch<T>& attitudes, std::size_t row) noexcept {
    bool is_double = true;
    DoubleDouble q[4];
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = attitudes[k][row];
        is_double = is_double && q[k].lo == 0.0;
    }
    const DoubleDouble excess = squared_norm(q) - 1.0;
    constexpr double rounding = 4 * 0x1p-52;
    return attitudes.are_quaternions && attitudes.is_as_given[row] && is_double &&
           __builtin_fabs(excess.hi - rounding * rounding) <= 2.0 * rounding; // | |q| - 1 | <= 4 eps
}

struct Kernel {
    std::size_t size; ///< how many numbers there are
    BatchKernel<double> fast;
    BatchKernel<DoubleDouble> exact;
    RowKernel one;
    CarefulKernel careful;
    // First phases of plain rows, to about 2^-66, or null. They leave some numbers in doubt, see doubt_of(). What they
    // make of the others is what the exact kernels make of them, with nothing to report.
    /// BatchKernel::read() to a quaternion that is unit: each component as it is printed, except for its sign. False
    /// where it proves nothing of any row.
    bool (*read_first)(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<double>& attitudes,
                       std::uint64_t* doubts) noexcept = nullptr;
    /// BatchKernel::write().
    void (*write_first)(const Spec& spec, double lock_margin, const AttitudeBatch<DoubleDouble>& attitudes,
                        std::size_t rows, double* numbers, std::uint64_t* doubts) noexcept = nullptr;
    /// Numbers of this size or more are plain for exact.read. Its products to 106 bits, of the sixth degree (the
    /// squares of a normal in 5d), or of one that is stated beside another limit, stay above 2^-960 down to 2^-150. But
    /// sums that cancel keep more digits in Careful.
    double least_plain_number = 0x1p-112;
    bool is_quaternion = false; ///< its numbers are the attitude, of any size
    std::size_t column = 0;     ///< of entries of a matrix: how many there are of one scale; 9: all
    /// What the signs of the numbers do not show of the matrix, 0 or 1, or null.
    unsigned (*hidden_sign)(const double* numbers) noexcept = nullptr;
    bool first_takes_any_size = false; ///< the bounds of its first phases hold for what is not plain, too
};

#define ROTCONV_LINE(id) extern const Kernel id;
/// One for each line of the table of representations, defined at the end of its X_batch.cpp.
namespace kernels {
ROTCONV_REPRESENTATIONS(ROTCONV_LINE)
} // namespace kernels
#undef ROTCONV_LINE

/// The first N of some numbers, in as many digits as To has.
template <class From, class To, std::size_t N> ROTCONV_INLINE void load(const From* numbers, To (&taken)[N]) noexcept {
    for (std::size_t k = 0; k < N; ++k) {
        taken[k] = rounded_to<To>(numbers[k]);
    }
}
/// And puts them there.
template <class From, class To, std::size_t N> ROTCONV_INLINE void store(const From (&numbers)[N], To* there) noexcept {
    for (std::size_t k = 0; k < N; ++k) {
        there[k] = rounded_to<To>(numbers[k]);
    }
}

/// The kernels of a representation, a class with `size`, how many numbers there are, and the functions read() and
/// write() of BatchKernel, read_one() and write_one() of RowKernel, and read_carefully() and write_one() of
/// CarefulKernel, over a scalar where there are several.
template <class Formula>
constexpr Kernel kernel_of_formula{.size = Formula::size,
                                   .fast = {.read = Formula::read, .write = Formula::write},
                                   .exact = {.read = Formula::read, .write = Formula::write},
                                   .one = {.read = Formula::read_one, .write = Formula::write_one},
                                   .careful = {.read = Formula::read_carefully, .write = Formula::write_one}};

/// Numbers of rows in a first phase, and which of them do not round clearly.
template <std::size_t size> struct FirstNumbers {
    static constexpr double largest_off = 0x1p-68; ///< from there on rows are left open: what may be 0 is below 2^-66

    double off[batch_rows];         ///< a bound on the errors of a row's numbers
    std::uint64_t open[batch_rows]; ///< how many do not round clearly

    /// Numbers of the row i, of which `off` is known, rounded.
    ROTCONV_INLINE void set(std::size_t i, const Fixed (&numbers)[size], Columns<double, size>& rounded) noexcept {
        const double error = off[i] < largest_off ? off[i] : __builtin_nan("");
        std::uint64_t count = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const double above = numbers[k].hi + (numbers[k].lo + error);
            const double below = numbers[k].hi + (numbers[k].lo - error);
            count += above == below ? 0U : 1U; // of nan, too
            rounded[k].set(i, above);
        }
        off[i] = error;
        open[i] = count;
    }

    /// The doubts of doubt_of(), other_doubt where one is not about a 0.
    void find_doubts(const Columns<double, size>& rounded, std::size_t rows, std::uint64_t* doubts) const noexcept {
        std::uint64_t all_open = 0;
        for (std::size_t i = 0; i < rows; ++i) {
            all_open |= open[i];
        }
        for (std::size_t i = 0; i < rows && all_open != 0; ++i) {
            std::uint64_t others = open[i];
            for (std::size_t k = 0; k < size && open[i] != 0; ++k) {
                const bool is_near_0 = __builtin_fabs(rounded[k][i]) <= 2.0 * off[i];
                doubts[i] |= is_near_0 ? std::uint64_t{1} << k : 0U;
                others -= is_near_0 ? 1U : 0U;
            }
            doubts[i] |= others == 0 ? 0U : other_doubt;
        }
    }
};

/// Those that write, of a class Formula with
///     numbers_of(const T (&q)[4], T (&numbers)[size])
///     error_of(const double (&q)[4], double off)   ErrorBound of the numbers, see AttitudeBatch::off
template <class Formula, std::size_t count> struct WrittenByFormula {
    static constexpr std::size_t size = count;

    /// The row's diagnostics; it may replace numbers, doubles or of type T.
    template <class T, class Number>
    ROTCONV_INLINE static DiagnosticSet complete(const T (&/*q*/)[4], Number* /*numbers*/) noexcept {
        return {};
    }

    template <class T> static void write(const Spec& /*spec*/, double /*lock_margin*/,
                                         const AttitudeBatch<T>& attitudes, std::size_t rows, double* numbers,
                                         double* /*rest*/, DiagnosticSet* diagnostics, std::uint64_t* doubts) noexcept {
        Columns<T, size> columns;
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            T result[size];
            attitudes.get(i, q);
            Formula::numbers_of(q, result);
            columns.set(i, result);
        }
        if constexpr (!std::is_same_v<T, double>) {
            for (std::size_t i = 0; i < rows; ++i) {
                const double q[4] = {attitudes[0].hi[i], attitudes[1].hi[i], attitudes[2].hi[i], attitudes[3].hi[i]};
                const ErrorBound error = Formula::error_of(q, attitudes.off[i]);
                for (unsigned k = 0; k < size; ++k) {
                    const DoubleDouble number = columns[k][i];
                    doubts[i] |= doubt_of(number, error.absolute + error.relative * __builtin_fabs(number.hi), k);
                }
            }
        }
        to_rows(columns, rows, numbers);
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            attitudes.get(i, q);
            diagnostics[i] = Formula::complete(q, numbers + size * i);
        }
    }
    /// Kernel::write_first, of a Formula that has also
    ///     first_error_of(double off)   a bound on the errors of its numbers_of() in Fixed
    static void write_first(const Spec& /*spec*/, double /*lock_margin*/, const AttitudeBatch<DoubleDouble>& attitudes,
                            std::size_t rows, double* numbers, std::uint64_t* doubts) noexcept {
        Columns<double, size> columns;
        FirstNumbers<size> first;
        for (std::size_t i = 0; i < rows; ++i) {
            Fixed q[4];
            Fixed result[size];
            for (std::size_t k = 0; k < 4; ++k) {
                q[k] = {attitudes[k].hi[i], attitudes[k].lo[i]};
            }
            Formula::numbers_of(q, result);
            first.off[i] = Formula::first_error_of(attitudes.off[i]);
            first.set(i, result, columns);
        }
        to_rows(columns, rows, numbers);
        first.find_doubts(columns, rows, doubts);
    }
    template <class T>
    static DiagnosticSet write_one(const Spec& /*spec*/, double /*lock_margin*/, const T (&q)[4], T* numbers) noexcept {
        T result[size];
        Formula::numbers_of(q, result);
        const DiagnosticSet found = Formula::complete(q, result);
        store(result, numbers);
        return found;
    }
};

/// Those that read, and find no defect, of a class Formula with
///     quaternion_of(const double* numbers, T (&q)[4])   of any length
///     size_of(const double* numbers)                    that length or the largest component, about
///     off_of(const double* numbers)                     AttitudeBatch::off, once that is brought to 1/2 to 1
template <class Formula> struct ReadByFormula {
    template <class T>
    static void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
        for (std::size_t i = 0; i < rows; ++i) {
            T q[4];
            attitudes.error[i] = read_one(spec, numbers + Formula::size * i, q, attitudes.defect[i]);
            attitudes.off[i] = Formula::off_of(numbers + Formula::size * i);
            attitudes.set(i, q);
        }
    }
    template <class T> ROTCONV_INLINE static Error read_one(const Spec& /*spec*/, const double* numbers, T (&q)[4],
                                                            double& defect) noexcept {
        Formula::quaternion_of(numbers, q);
        const double size = Formula::size_of(numbers);
        const double scale = size < 0x1p1000 ? unit_scale(size) : unit_scale(size * 0x1p-100) * 0x1p-100;
        for (T& component : q) {
            component = scaled(component, scale);
        }
        defect = 0.0;
        return all_finite(numbers, Formula::size) ? Error::none : Error::not_finite;
    }
    static void read_carefully(const Spec& /*spec*/, const double* numbers, Careful (&q)[4]) noexcept {
        Formula::quaternion_of(numbers, q);
    }
};

/// The diagnostic half_turn if pi - theta <= half_turn_margin, otherwise none.
template <class T> ROTCONV_INLINE DiagnosticSet half_turn_of(const T (&q)[4]) noexcept {
    const double w = to_double(q[0]);
    const double x = to_double(q[1]);
    const double y = to_double(q[2]);
    const double z = to_double(q[3]);
    constexpr double limit = 0.5 * half_turn_margin;
    return {DiagnosticKind::half_turn, w * w <= limit * limit * ((x * x + y * y) + z * z)};
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
