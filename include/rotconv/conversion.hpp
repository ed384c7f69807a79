#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// A row of numbers, or the inverse of what it means, as a rotation that is read again where more digits count.
struct FixedFactor {
    Spec spec{};
    double numbers[9] = {}; // NOLINT(*-avoid-c-arrays): kernels read it; in the representation's own order
    double rest[4] = {};    // NOLINT(*-avoid-c-arrays): added to the quaternion that they mean
    bool is_inverse = false;
};

/// A rotation by which all attitudes are multiplied.
struct FixedRotation {
    FixedRotation(const Rotation& rounded = {}, const std::array<double, 4>& more = {});
    /// The attitude of one row of numbers.
    /// @pre read_attitude() finds a rotation in the row
    [[nodiscard]] static FixedRotation of_numbers(const Spec& spec, std::span<const double> numbers);

    [[nodiscard]] bool is_identity() const noexcept {
        return rotation.is_identity() && rest[1] == 0.0 && rest[2] == 0.0 && rest[3] == 0.0;
    }
    [[nodiscard]] FixedRotation inverse() const;
    /// The composition, like that of Rotation.
    friend FixedRotation operator*(const FixedRotation& a, const FixedRotation& b);

    Rotation rotation;
    std::array<double, 4> rest;       ///< w, x, y, z to 106 bits, less those of `rotation`
    double off = 0.0;                 ///< a bound on the error of these sums
    std::vector<FixedFactor> factors; ///< whose product it is
};

/// What a conversion accepts and reports, and the rotations by which it multiplies.
struct ConversionSettings {
    double tolerance = default_tolerance; ///< largest defect that is accepted, from 0 to infinity; see Reading::defect
    double lock_margin = euler::default_lock_margin; ///< radians, from 0; see euler::from_rotation()
    bool sensitivity = false;                        ///< report margin, condition and exact defect of each row
    FixedRotation left{};                            ///< R becomes left R: other reference axes
    FixedRotation right{};                           ///< R becomes R right: other body axes
    bool fast = false;                               ///< plain double arithmetic, accurate to a few eps
};

/// The attitude of one row of numbers in the conventions of the spec.
/// @throw std::invalid_argument if there are fewer than spec.size() numbers
[[nodiscard]] Reading read_attitude(const Spec& spec, std::span<const double> numbers);

/// What is unusual about a row of finite numbers.
/// @param defect that of a quaternion or matrix, reported above `reported_defect`
/// @throw std::invalid_argument if there are fewer than spec.size() numbers
[[nodiscard]] UnusualNumbers unusual_numbers(const Spec& spec, std::span<const double> numbers, double defect = 0.0);

/// All numbers of a matrix of Eigen, as they are stored: one column after the other, except for Eigen::RowMajor.
template <class Derived> [[nodiscard]] std::span<double> numbers_of(Eigen::PlainObjectBase<Derived>& matrix) noexcept {
    return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}
template <class Derived> std::span<const double> numbers_of(const Eigen::PlainObjectBase<Derived>& matrix) noexcept {
    return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

/// All numbers of a std::vector of matrices of a fixed size, or of quaternions, of Eigen.
template <class Element, class Allocator>
requires(std::same_as<Element, Eigen::Quaterniond> || Element::SizeAtCompileTime > 0)
    [[nodiscard]] std::span<double> numbers_of(std::vector<Element, Allocator>& elements) noexcept {
    static_assert(std::same_as<typename Element::Scalar, double> && sizeof(Element) % sizeof(double) == 0);
    // NOLINTNEXTLINE(*-reinterpret-cast): an element is its numbers alone
    return {reinterpret_cast<double*>(elements.data()), elements.size() * (sizeof(Element) / sizeof(double))};
}
template <class Element, class Allocator>
requires(std::same_as<Element, Eigen::Quaterniond> || Element::SizeAtCompileTime > 0)
    [[nodiscard]] std::span<const double> numbers_of(const std::vector<Element, Allocator>& elements) noexcept {
    static_assert(std::same_as<typename Element::Scalar, double> && sizeof(Element) % sizeof(double) == 0);
    // NOLINTNEXTLINE(*-reinterpret-cast): an element is its numbers alone
    return {reinterpret_cast<const double*>(elements.data()), elements.size() * (sizeof(Element) / sizeof(double))};
}

struct ZeroTable;

/// The conversion from one representation to another, resolved once and then run over batches of rows.
/// Thread-safe: run() changes nothing in it.
class Conversion {
public:
    /// @throw std::invalid_argument if a Spec has a modifier that has no meaning for its representation
    Conversion(const Spec& from, const Spec& to, const ConversionSettings& settings = {});

    [[nodiscard]] const Spec& from() const noexcept { return from_; }
    [[nodiscard]] const Spec& to() const noexcept { return to_; }
    [[nodiscard]] const ConversionSettings& settings() const noexcept { return settings_; }

    /// Converts rows of from().size() numbers each into rows of to().size() numbers. The numbers of a row with an error
    /// become nan. Except with ConversionSettings::fast, each number is the double nearest to the exact function of the
    /// numbers read. No number becomes -0. A program that is linked with -ffast-math sets the processor to replace
    /// numbers below 2.3e-308 by 0 when it starts: such numbers are then lost here too.
    /// @param reports is replaced by the reports of the rows that have an error or a diagnostic (with
    /// ConversionSettings::sensitivity, of all rows), in row order. Most rows have none. A vector that is reused is not
    /// allocated again
    /// @param rest if not empty, receives the exact numbers less those written, for ContinuousNumbers::run()
    /// @throw std::invalid_argument if `in` is not whole rows, or `out` or `rest` has no room for the results
    ///
    /// Eigen stores matrices by columns and quaternions as x y z w: the elements of a vector of Eigen::Matrix3d are
    /// rows of the Spec `eigen_matrix`, and so are the columns of an Eigen::Matrix<double, 9, Eigen::Dynamic>:
    ///     Conversion(eigen_matrix, eigen_quaternion).run(numbers_of(matrices), numbers_of(quaternions), reports);
    void run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
             std::span<double> rest = {}) const;
    /// The numbers of one row once more. What the exact ones have beside those written is a sum of doubles, for each
    /// number as many as `rest` has room for; for ContinuousNumbers::Again.
    void again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const;

private:
    Spec from_;
    Spec to_;
    ConversionSettings settings_;
    std::shared_ptr<ZeroTable> zeros_;
};

} // namespace rotconv
