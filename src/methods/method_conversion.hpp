#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>

#include "method.hpp"

namespace rotconv {

/// A conversion by one method. Errors, defects and diagnostics are those of rotconv's own conversion, and every answer
/// has its angle to the attitude. Thread-safe: run() changes nothing in the object.
class MethodConversion {
public:
    /// Throws std::invalid_argument if the method is one of another pair.
    MethodConversion(const Conversion& own, const Method& method);

    /// By rotconv's own two, default and fast, which every pair has, and by all that are published.
    [[nodiscard]] static std::vector<MethodConversion> all(const Conversion& own);

    [[nodiscard]] const Spec& from() const noexcept { return own_.from(); }
    [[nodiscard]] const Spec& to() const noexcept { return own_.to(); }
    [[nodiscard]] std::string_view name() const noexcept { return name_; }

    /// As Conversion::run(). `angles` are set to the angle from each attitude to the answer in radians, nan if the
    /// answer is not an attitude or the row has an error, 0 if it is infinite as it should be; so is
    /// RowReport::deviation. Max error of an angle: 5 eps.
    void run(std::span<const double> in, std::span<double> out, std::vector<double>& angles,
             std::vector<RowReport>& reports) const;

private:
    MethodConversion(const Conversion& own, std::string_view name, const Method* method);

    /// The numbers that published methods start from: in the representation's own order, active, in radians, of the
    /// rotation that is to be written.
    [[nodiscard]] std::vector<double> starting_numbers(std::span<const double> in) const;
    /// Writes the numbers of the published method's answers.
    void run_method(std::span<const double> in, std::span<double> out) const;
    /// Sets the angles from attitudes to their answers.
    void measure(std::span<const double> attitudes, std::span<const double> answers, std::vector<double>& angles) const;

    Conversion own_;
    std::string_view name_;
    std::optional<Conversion> rotated_; ///< to quaternions, if own_ rotates the attitudes
    std::optional<Conversion> fast_;    ///< which answers by the method of that name
    const Method* method_;              ///< null: rotconv's own
};

} // namespace rotconv
