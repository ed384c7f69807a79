#pragma once

#include <span>

#include <rotconv/conversion.hpp>

#include "method.hpp"

namespace rotconv {

/// A conversion whose numbers are a method's: errors, defects and diagnostics are those of rotconv's own, which also
/// says how far the method's answer is off.
/// Thread-safe: running it changes nothing in it.
class MethodConversion {
public:
    /// Throws std::invalid_argument where the method is one of another pair, or rotconv's own.
    MethodConversion(const Conversion& own, const Method& method);

    [[nodiscard]] const Spec& from() const noexcept { return own_.from(); }
    [[nodiscard]] const Spec& to() const noexcept { return own_.to(); }

    /// As Conversion::run(). Report::deviation is the angle from the attitude to the method's answer, nan where that is
    /// none.
    void run(std::span<const double> in, std::span<double> out, std::span<Report> reports) const noexcept;

private:
    void run_batch(const double* in, double* out, std::span<Report> reports) const noexcept;

    Conversion own_;
    const Method* method_;
};

} // namespace rotconv
