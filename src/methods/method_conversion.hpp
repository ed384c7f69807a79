#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>

#include "method.hpp"

namespace rotconv {

/// A conversion whose numbers are those of one method, or of each of its pair: errors, defects and diagnostics are
/// those of rotconv's own, and every answer's angle to the attitude is told.
/// Thread-safe: running it changes nothing in it.
class MethodConversion {
public:
    /// Throws std::invalid_argument where the method is one of another pair.
    MethodConversion(const Conversion& own, const Method& method);

    /// rotconv's own two, default and fast, which every pair has, and all that are published.
    [[nodiscard]] static MethodConversion all(const Conversion& own);

    [[nodiscard]] const Spec& from() const noexcept { return own_.from(); }
    [[nodiscard]] const Spec& to() const noexcept { return own_.to(); }
    /// Of each row's answers, in their order.
    [[nodiscard]] std::vector<std::string_view> names() const;

    /// As Conversion::run(), with names().size() answers to each row, one behind the other, of which RowReport::row is
    /// the index. `angles` become those from the attitude to each answer, in radians and right to 5 eps, nan where the
    /// answer describes none or the row has an error; 0 where it is infinite as it should be. RowReport::deviation is
    /// the same.
    /// @param with_angles each answer's stands in `out` too, behind its numbers
    void run(std::span<const double> in, std::span<double> out, std::vector<double>& angles,
             std::vector<RowReport>& reports, bool with_angles = false) const;

private:
    explicit MethodConversion(const Conversion& own);

    /// What published methods start from: numbers in the representation's own order, active, in radians, of the
    /// rotation that is to be written.
    [[nodiscard]] std::vector<double> starting_numbers(std::span<const double> in) const;
    /// @param room for as many numbers as are written
    void answer(const Method& method, std::span<const double> numbers, std::span<double> room,
                std::span<double> written) const;
    /// The angles from attitudes, given or turned, to `count` answers to all of them, one answer behind the other.
    void measure(std::span<const double> attitudes, std::span<const double> answers, std::size_t count,
                 std::span<double> angles) const;

    Conversion own_;
    std::optional<Conversion> turned_; ///< to quaternions, where own_ turns the attitudes
    std::optional<Conversion> fast_;   ///< the answer after own_'s, where all are wanted
    std::vector<const Method*> published_;
};

} // namespace rotconv
