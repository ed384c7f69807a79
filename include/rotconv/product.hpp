#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <rotconv/conversion.hpp>

namespace rotconv {

/// The product A B of the two attitudes of a row, in any representations: B is applied first. A `passive` Spec inverts,
/// so the relative attitude R_REF' R is a composition from `quat:passive` and `quat`.
///
/// Each number of the result is the double nearest to the exact function of the numbers read, like those of a
/// Conversion. Thread-safe: run() changes nothing in it.
class Composition {
public:
    /// @param settings `left` and `right` turn only A, before it is multiplied; `fast` is not used
    /// @throw std::invalid_argument if a modifier of a spec has no meaning for its representation
    Composition(const Spec& first, const Spec& second, const Spec& to, const ConversionSettings& settings = {});

    /// Its like for rows in which B is between two attitudes C and D, on the shortest rotation from C to D: numbers of
    /// A, C and D, and then six, of which three sum up to the distance from C to B and three to that from C to D.
    /// Errors of C and D, and numbers that are unusual in them, are not reported.
    [[nodiscard]] Composition interpolating() const;

    [[nodiscard]] const Spec& first() const noexcept { return first_; }
    [[nodiscard]] const Spec& second() const noexcept { return second_; }
    [[nodiscard]] const Spec& to() const noexcept { return to_; }
    [[nodiscard]] const ConversionSettings& settings() const noexcept { return settings_; }

    /// Like Conversion::run(), of rows of first().size() + second().size() numbers. An error of B has 1 as
    /// RowReport::at_fault.
    void run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
             std::span<double> rest = {}) const;
    /// Like Conversion::again().
    void again(std::span<const double> row, std::span<double> numbers, std::span<double> rest) const;

private:
    Spec first_;
    Spec second_;
    Spec to_;
    ConversionSettings settings_;
    bool interpolates_ = false;
    std::shared_ptr<ZeroTable> zeros_;
};

/// The vectors v_ref = R v_body of rows of an attitude R, in any representation, and a vector. With a `passive` Spec
/// the result is v_body of v_ref.
///
/// Each number of the result is the double nearest to the exact function of the numbers read. Thread-safe: run()
/// changes nothing in it.
class VectorRotation {
public:
    /// @throw std::invalid_argument if a modifier of the spec has no meaning for its representation
    explicit VectorRotation(const Spec& from, const ConversionSettings& settings = {});

    [[nodiscard]] const Spec& from() const noexcept { return from_; }
    [[nodiscard]] const ConversionSettings& settings() const noexcept { return settings_; }

    /// Like Conversion::run(), of rows of from().size() + 3 numbers, into rows of 3. The sensitivity is that of the
    /// attitude as it was read. Error::not_finite is also that of a vector, and Error::overflow that of a result.
    void run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const;

private:
    Spec from_;
    ConversionSettings settings_;
    std::shared_ptr<ZeroTable> zeros_;
};

} // namespace rotconv
