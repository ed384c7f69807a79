#pragma once

#include <cstddef>
#include <cstdint>

#include <rotconv/conversion.hpp>
#include <rotconv/spec.hpp>

#include "../representations/attitude_batch.hpp"

namespace rotconv {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

/// No representation has more.
inline constexpr std::size_t most_numbers = 9;

/// A quaternion of 106 bits: w, x, y, z in two parts each, as those of Rotation, and a bound on their error.
struct ExactQuaternion {
    double hi[4];
    double lo[4];
    double off;
};

/// The bound on the errors of a product of two quaternions, below 2 in length, whose components are off by at most that
/// much and 2^-99 of themselves: each of its components is a sum of four products, 4 (a + b + a b) and 2^-96 of them.
[[nodiscard]] constexpr double off_of_product(double a, double b) noexcept { return 4.0 * (a + b + a * b) + 0x1p-95; }

/// Constant rotations by which attitudes are multiplied, from the left and from the right, where there are such, and
/// the rows of numbers from which they are read again.
struct FixedRotations {
    bool has_left;
    bool has_right;
    ExactQuaternion left;
    ExactQuaternion right;
    const FixedFactor* left_factors;
    std::size_t left_count;
    const FixedFactor* right_factors;
    std::size_t right_count;
};
inline constexpr FixedRotations no_rotations{};

/// What is known of the zeros of a conversion, see known_numbers.hpp: entries that are read and written as a whole.
struct ZeroTable {
    static constexpr std::size_t size = 1024;
    std::uint64_t entries[size]{};
    std::uint64_t sums[size]{};
};

/// What the conversion of a batch needs beside its rows.
struct ConversionBatch {
    const Spec* from = nullptr;
    const Spec* to = nullptr;
    double lock_margin = 0.0;
    const FixedRotations* fixed = nullptr; ///< of the attitudes as they are written
    ZeroTable* zeros = nullptr;            ///< may be null
    std::size_t rest_size =
        1; ///< how many doubles of `rest` a number has; more than one for rows that are answered once more
};

/// What a batch of products of two attitudes needs beside its rows.
struct ProductBatch {
    const Spec* first = nullptr;
    const FixedRotations* fixed = nullptr; ///< of the first attitudes
    const Spec* second = nullptr;
    const Spec* to = nullptr;
    double lock_margin = 0.0;
    ZeroTable* zeros = nullptr;
    std::size_t rest_size = 1; ///< see ConversionBatch
    // The second attitudes are between those of rows and of these, see interpolate() of careful_rows.hpp; or null.
    const double* later = nullptr;
    const double* fractions = nullptr; ///< six numbers, one such group every `row_size` numbers
    std::size_t row_size = 0;
};

/// The functions that are compiled for one kind of processor. Batches have at most `batch_rows` rows. Numbers are in
/// the representation's own order. Diagnostics are what there is to report of each row; the sets are empty at first.
struct KernelTable {
    const char* target; ///< that kind of processor, for people
    /// From one representation to the other, each number rounded once, none -0. `attitudes` become those that are
    /// written, rounded, with the defects and errors of the rows. `rest`, which may be null: what the exact numbers
    /// have beside those written, as sums of `rest_size` doubles each; -0.0 alone where it is known that there is
    /// nothing.
    using Convert = void(const ConversionBatch& batch, const double* in, std::size_t rows,
                         AttitudeBatch<double>& attitudes, double* out, double* rest,
                         DiagnosticSet* diagnostics) noexcept;
    Convert* convert;
    /// The first phase of convert(), false where the two representations have none: where it proves how the exact
    /// numbers round, at the price of plain double. The other rows are left open, and mean nothing yet.
    bool (*convert_first)(const ConversionBatch& batch, const double* in, std::size_t rows,
                          AttitudeBatch<double>& attitudes, double* out, bool* open) noexcept;
    Convert* convert_fast; ///< in plain double
    /// The attitudes that rows describe, between the fixed rotations, then rounded once.
    void (*read)(const Spec& spec, const FixedRotations& fixed, const double* numbers, std::size_t rows,
                 AttitudeBatch<double>& attitudes) noexcept;
    /// See relate(); angles below 2^-100 need not be right.
    void (*relate)(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
                   AttitudeBatch<double>& relative, double* angles) noexcept;
    /// The products of the first and the second attitudes of rows, each number rounded once; `rest` as in convert().
    /// `attitudes` become the two attitudes and their product, rounded, with the defects and errors of the two.
    void (*multiply)(const ProductBatch& batch, const double* first, const double* second, std::size_t rows,
                     AttitudeBatch<double>* const (&attitudes)[3], double* out, double* rest,
                     DiagnosticSet* diagnostics) noexcept;
    /// R v of each row's attitude R and vector v, each number rounded once; infinite where it is too large. `attitudes`
    /// become R, rounded.
    void (*rotate)(const Spec& spec, ZeroTable* zeros, const double* numbers, const double* vectors, std::size_t rows,
                   AttitudeBatch<double>& attitudes, double* out) noexcept;
    /// One row to the last bit.
    void (*read_exactly)(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept;
    /// One row in plain double, q as w, x, y, z.
    Error (*read_one)(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept;
    DiagnosticSet (*write_one)(const Spec& spec, double lock_margin, const double (&q)[4], double* numbers) noexcept;
};

/// That of this processor. All give the same numbers.
[[nodiscard]] const KernelTable& kernel_table() noexcept;

/// One row; its defect, up to `reported_defect`, is a bound.
[[nodiscard]] Reading read_row(const Spec& spec, const double* numbers) noexcept;

/// One row; with a lock margin of 0 no angle is set to 0 at gimbal lock. Returns what there is to report of it.
DiagnosticSet write_row(const Spec& spec, const Rotation& rotation, double* numbers, double lock_margin = 0.0) noexcept;

/// The rotations between attitudes, R_REF' R, each component rounded once: the vector part of equal quaternions is 0.
/// Their angles are in radians.
void relate(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
            AttitudeBatch<double>& relative, double* angles) noexcept;

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
