#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>

#include "method.hpp"

namespace rotconv {

/// A conversion by one method, or by each method of its pair. Errors, defects and diagnostics are those of rotconv's
/// own conversion, and every answer has its angle to the attitude. Thread-safe: run() changes nothing in the object.
class MethodConversion {
public:
    /// Throws std::invalid_argument if the method is one of another pair.
    MethodConversion(const Conversion& own, const Method& method);

    /// rotconv's own two, default and fast, which every pair has, and all that are published.
    [[nodiscard]] static MethodConversion all(const Conversion& own);

    [[nodiscard]] const Spec& from() const noexcept { return own_.from(); }
    [[nodiscard]] const Spec& to() const noexcept { return own_.to(); }
    /// The names of each row's answers, in their order.
    [[nodiscard]] std::vector<std::string_view> names() const;

    /// As Conversion::run(), with names().size() answers to each row, one after the other. `angles` are set to the
    /// angle from the attitude to each answer in radians, nan if the answer is not an attitude or the row has an error,
    /// 0 if it is infinite as it should be; RowReport::deviation to the row's largest, or nan. Max error of an angle:
    /// 5 eps.
    void run(std::span<const double> in, std::span<double> out, std::vector<double>& angles,
             std::vector<RowReport>& reports) const;

private:
    explicit MethodConversion(const Conversion& own);

    /// The numbers that published methods start from: in the representation's own order, active, in radians, of the
    /// rotation that is to be written.
    [[nodiscard]] std::vector<double> starting_numbers(std::span<const double> in) const;
    /// Writes the numbers of a method's answers.
    /// @param room memory for as many numbers
    void run_method(const Method& method, std::span<const double> numbers, std::span<double> room,
                    std::span<double> written) const;
    /// Sets the angles from attitudes to the `count` answers of each; in `answers`, each method's stand together.
    void measure(std::span<const double> attitudes, std::span<const double> answers, std::size_t count,
                 std::span<double> angles) const;

    Conversion own_;
    std::optional<Conversion> rotated_; ///< to quaternions, if own_ rotates the attitudes
    std::optional<Conversion> fast_;    ///< the answer after own_'s, if all are wanted
    std::vector<const Method*> published_;
};

} // namespace rotconv
