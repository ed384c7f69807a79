#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../core/representations/constant_turns.hpp"
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
    void run(std::span<const double> in, std::span<double> out, std::vector<Report>& reports) const;

private:
    /// `own`: the reports of rotconv's own numbers of these rows, of which the first is row `first`.
    void run_batch(const double* in, std::size_t first, std::size_t rows, double* out, std::span<const Report> own,
                   std::vector<Report>& reports) const;

    Conversion own_;
    const Method* method_;
    ConstantTurns turns_; ///< of attitudes as they are read
};

} // namespace rotconv
