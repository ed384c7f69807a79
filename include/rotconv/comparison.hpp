#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <rotconv/angle.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/frame.hpp>

namespace rotconv {

/// How attitudes are compared, and what is made of them.
struct ComparisonSettings {
    ConversionSettings reading{};                            ///< of both; the lock margin is that of the result
    double within = std::numeric_limits<double>::infinity(); ///< a larger angle is reported; in `unit`
    AngleUnit unit = AngleUnit::radians;                     ///< of angles
    std::optional<Spec> relative{};                          ///< the relative attitude is wanted, in this form
    Frame frame = Frame::body; ///< its axes: R_REF' R of the reference's body, R R_REF' of the reference axes
};

/// The angle between two attitudes R and R_REF of a row, whatever their representations.
///
/// It is twice the angle of (|v|, |s|) where (s, v) is the product of one quaternion and the other's inverse, formed
/// with products of 106 bits: 0 where the numbers of one SPEC are the same, and to their own digits where quaternions
/// near the identity differ by as little as 1e-150. Attitudes are read to 106 bits and rounded: 3.03 eps is the worst
/// found. Each number of the relative attitude is rounded once.
/// Thread-safe: running it changes nothing in it.
class Comparison {
public:
    Comparison(const Spec& from, const Spec& reference, const ComparisonSettings& settings = {});

    [[nodiscard]] const Spec& from() const noexcept { return from_; }
    [[nodiscard]] const Spec& reference() const noexcept { return reference_; }
    [[nodiscard]] const ComparisonSettings& settings() const noexcept { return settings_; }
    /// Numbers of a row: from().size() + reference().size().
    [[nodiscard]] std::size_t inputs() const noexcept { return from_.size() + reference_.size(); }
    /// Numbers of an answer: the angle, and those of the relative attitude where it is wanted.
    [[nodiscard]] std::size_t outputs() const noexcept;

    /// Answers rows of inputs() numbers with outputs() numbers each; as Conversion::run(), but an error of the second
    /// attitude has RowReport::of_reference, and DiagnosticKind::beyond has the angle in RowReport::deviation.
    void run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const;

private:
    void run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                   std::vector<RowReport>& reports) const;
    /// Behind each angle.
    void write_relative(const double* attitudes, const double* references, std::size_t rows, double* out,
                        DiagnosticSet* diagnostics) const noexcept;

    Spec from_;
    Spec reference_;
    ComparisonSettings settings_;
};

} // namespace rotconv
