#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include <rotconv/conversion.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// Follows a motion. The same attitude can be written with different numbers: the other sign of a quaternion or of an
/// axis, angles with whole turns added, the other triple of Euler angles. This class writes those nearest to the last
/// row's by Euclidean distance, with angles in radians, and the canonical ones if two are equally near. At gimbal lock
/// the third angle keeps its last value; at the identity, after any number of whole turns, the axis does.
class ContinuousNumbers {
public:
    /// Gives the canonical numbers of a row of run() once more, and their rest in many doubles, by Conversion::again().
    using Again = std::function<void(std::size_t row, std::span<double> numbers, std::span<double> rest)>;

    explicit ContinuousNumbers(const Spec& spec) noexcept : spec_(spec) {}

    /// Whether attitudes have other numbers than the canonical ones. If not, run() changes nothing.
    [[nodiscard]] bool have_choice() const noexcept;

    /// The next rows of spec.size() numbers in the order of the motion, with the reports and the `rest`, both from
    /// Conversion::run(). The very first row is left as it is. So is a row that has an error or a number that is not
    /// finite; the next row is not compared with it.
    /// @param rest with it, the numbers chosen are rounded once, from 106 bits; may be empty
    /// @param again with it, also those that 106 bits do not decide: it is called for their rows
    void run(std::span<double> numbers, std::span<const RowReport> reports, std::span<const double> rest = {},
             const Again& again = {});

    /// The numbers of the next attitude alone; they are in plain double arithmetic.
    /// @throw std::invalid_argument if there is no room for spec.size() numbers
    void next(const Rotation& attitude, std::span<double> numbers);

private:
    void choose(std::span<double> own, DiagnosticSet diagnostics, std::span<const double> rest, const Again& again,
                std::size_t row);

    Spec spec_;
    bool has_last_ = false;
    std::array<double, 4> last_{}; ///< as written; no representation with a choice has more
};

} // namespace rotconv
