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

/// A constant rotation by which attitudes are multiplied, and the rows of numbers from which it is read again, whose
/// product it is; without any there is none.
struct FixedSide {
    ExactQuaternion rotation{};
    const FixedFactor* factors = nullptr;
    std::size_t count = 0;
};
/// The one on the left of an attitude and the one on the right.
struct FixedRotations {
    FixedSide left{};
    FixedSide right{};
    bool right_first = false; ///< the order in which they are multiplied
};
inline constexpr FixedRotations no_rotations{};

/// What is known of the zeros of a conversion, see known_numbers.hpp: entries that are read and written as a whole.
struct ZeroTable {
    static constexpr std::size_t size = 1024;
    std::uint64_t entries[size]{};
    std::uint64_t sums[size]{};
};

/// What becomes of rows: the attitude of the first numbers, between the fixed rotations, then times that of the second
/// ones, is written as another representation, or turns a vector.
struct Task {
    const Spec* first = nullptr;
    const Spec* to = nullptr; ///< or null: the second numbers are a vector, which is turned
    double lock_margin = 0.0;
    const FixedRotations* fixed = &no_rotations;
    ZeroTable* zeros = nullptr; ///< may be null
    std::size_t rest_size = 1;  ///< how many doubles of `rest` a number has; more than one for rows that come once more
    const Spec* second = nullptr; ///< of the second attitude, or null

    /// What is written is the inverse.
    [[nodiscard]] ROTCONV_INLINE bool inverts() const noexcept { return to != nullptr && to->passive; }
    [[nodiscard]] ROTCONV_INLINE std::size_t second_size() const noexcept {
        return second != nullptr ? second->size() : 3;
    }
    [[nodiscard]] ROTCONV_INLINE std::size_t out_size() const noexcept { return to != nullptr ? to->size() : 3; }
};

/// The numbers of a row, or of the first of a batch.
struct TaskNumbers {
    const double* first = nullptr;
    const double* second = nullptr;    ///< null where there is neither a second attitude nor a vector
    const double* later = nullptr;     ///< the second attitude is between two, and this is the other; or null
    const double* fractions = nullptr; ///< six numbers: where it is between them, see interpolate() of careful_rows.hpp

    [[nodiscard]] ROTCONV_INLINE TaskNumbers of_row(const Task& task, std::size_t row) const noexcept {
        const std::size_t second_place = row * task.second_size();
        return {first + row * task.first->size(), moved(second, second_place), moved(later, second_place),
                moved(fractions, 6 * row)};
    }

private:
    ROTCONV_INLINE static const double* moved(const double* numbers, std::size_t by) noexcept {
        return numbers == nullptr ? nullptr : numbers + by;
    }
};

/// The attitudes of the rows of a task, rounded, with their defects and errors.
struct TaskAttitudes {
    AttitudeBatch<double>& written;         ///< of a vector's rotation that which turns it
    AttitudeBatch<double>* first = nullptr; ///< of a product, of which `written` has the first error and no defect
    AttitudeBatch<double>* second = nullptr;
};

/// The functions that are compiled for one kind of processor. Batches have at most `batch_rows` rows. Numbers are in
/// the representation's own order. Diagnostics are what there is to report of each row; the sets are empty at first.
struct KernelTable {
    const char* target; ///< that kind of processor, for people
    /// Numbers of a task, each rounded once, none -0; infinite where one is too large. `rest`, which may be null: what
    /// the exact numbers have beside those written, as sums of Task::rest_size doubles each; -0.0 alone where it is
    /// known that there is nothing.
    using Run = void(const Task& task, const TaskNumbers& numbers, std::size_t rows, const TaskAttitudes& attitudes,
                     double* out, double* rest, DiagnosticSet* diagnostics) noexcept;
    Run* run;
    /// The first phase of run() where one attitude is converted, false where the two representations have none: where
    /// it proves how the exact numbers round, at the price of plain double. The other rows are left open, and mean
    /// nothing yet.
    bool (*run_first)(const Task& task, const double* in, std::size_t rows, AttitudeBatch<double>& attitudes,
                      double* out, bool* open) noexcept;
    Run* run_fast; ///< in plain double; of one attitude
    /// The attitudes that rows describe, between the fixed rotations, then rounded once.
    void (*read)(const Spec& spec, const FixedRotations& fixed, const double* numbers, std::size_t rows,
                 AttitudeBatch<double>& attitudes) noexcept;
    /// The angles between attitudes, in radians: of R_REF' R, each component of its quaternion rounded once, so that
    /// the vector part of equal quaternions is 0.
    void (*relate)(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
                   double* angles) noexcept;
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

// NOLINTEND(*-avoid-c-arrays)

} // namespace rotconv
