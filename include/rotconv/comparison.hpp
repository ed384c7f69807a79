#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <rotconv/angle.hpp>
#include <rotconv/conversion.hpp>

namespace rotconv {

/// How attitudes are compared.
struct ComparisonSettings {
    /// For both attitudes; `left` and `right` turn only the first attitude, R.
    ConversionSettings reading{};
    double within = std::numeric_limits<double>::infinity(); ///< a larger angle is reported; in the angles' unit
    double per_radian = 1.0; ///< how many of that unit are a radian, such as degrees_per_radian
    /// Write both attitudes too, as they were compared: quaternions of norm 1/2 to 2.
    bool attitudes = false;
};

/// The angle between two attitudes R and R_REF of a row, in any two representations.
///
/// The angle is twice that of (|v|, |s|), where (s, v) is the product of one quaternion and the inverse of the other,
/// formed with products of 106 bits. It is 0 for equal numbers of one SPEC, and quaternions near the identity may
/// differ by as little as 1e-150. Attitudes are read to 106 bits and rounded; the worst error of
/// the angle that was found is 3.10 eps.
/// Thread-safe: run() changes nothing in it. Composition has the relative attitude.
class Comparison {
public:
    /// @throw std::invalid_argument if a modifier of a spec has no meaning for its representation
    Comparison(const Spec& from, const Spec& reference, ComparisonSettings settings = {});

    [[nodiscard]] const Spec& from() const noexcept { return from_; }
    [[nodiscard]] const Spec& reference() const noexcept { return reference_; }
    [[nodiscard]] const ComparisonSettings& settings() const noexcept { return settings_; }
    /// Numbers of a row of input: from().size() + reference().size().
    [[nodiscard]] std::size_t inputs() const noexcept { return from_.size() + reference_.size(); }
    /// Numbers of a row of output: the angle, then those of both attitudes if the settings want them.
    [[nodiscard]] std::size_t outputs() const noexcept { return settings_.attitudes ? 9 : 1; }

    /// Like Conversion::run(). An error of the second attitude has 1 as RowReport::at_fault, and RowReport::deviation
    /// is the angle.
    void run(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports) const;

private:
    Spec from_;
    Spec reference_;
    ComparisonSettings settings_;
};

} // namespace rotconv
