#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include <rotconv/rotation.hpp>

namespace rotconv {

/// Why numbers do not describe a rotation, or cannot be carried on. Errors are data only; the text of a message is left
/// to the program that prints it.
enum class Error : std::uint8_t {
    none,
    not_finite,      ///< a number is nan or infinite
    overflow,        ///< finite numbers whose result is too large for a double
    zero_quaternion, ///< all four components are 0
    zero_axis,       ///< an axis of length 0 with an angle that is not 0
    not_proper,      ///< a matrix with det <= 0: singular, or a reflection
    rank_deficient,  ///< two columns that do not span a plane, or a matrix of nearly rank one
    defect,          ///< further from a rotation than the tolerance allows
    singular,        ///< the set has no rates at this attitude, or a motion has reached where it has none
    coarse_step,     ///< the body may turn by more in one step than the set can follow
    time_order,      ///< not later than the sample before, or by less than 1e-100 s
    past_half_turn,  ///< differences: the body may have turned by half a turn or more since the sample before
    ended,           ///< an earlier row of the propagation has failed: nothing follows on it
};

/// The tolerance that accepts every defect.
inline constexpr double any_defect = std::numeric_limits<double>::infinity();

/// What came of reading numbers: a rotation, or an error that says why there is none. Tests as true where there is a
/// rotation.
class Reading {
public:
    Reading(const Rotation& rotation, double defect = 0.0) noexcept : rotation_(rotation), defect_(defect) {}
    Reading(Error error, double defect = 0.0) noexcept : defect_(defect), error_(error) {}

    [[nodiscard]] explicit operator bool() const noexcept { return error_ == Error::none; }
    /// @throw std::logic_error where there is none
    [[nodiscard]] const Rotation& rotation() const& {
        if (error_ != Error::none) [[unlikely]] {
            throw_no_rotation();
        }
        return rotation_;
    }
    /// Of a temporary by value, which a reference may outlive.
    [[nodiscard]] Rotation rotation() && { return static_cast<const Reading&>(*this).rotation(); }
    /// The same.
    [[nodiscard]] const Rotation& operator*() const& { return rotation(); }
    [[nodiscard]] Rotation operator*() && { return std::move(*this).rotation(); }
    [[nodiscard]] const Rotation* operator->() const { return &rotation(); }
    /// Error::none where there is a rotation.
    [[nodiscard]] Error error() const noexcept { return error_; }
    /// How far the numbers were from describing a rotation exactly: | |q| - 1 |, or the largest singular value of M -
    /// (polar factor of M); 0 for others. Up to `reported_defect` it may be an upper bound.
    [[nodiscard]] double defect() const noexcept { return defect_; }

private:
    [[noreturn]] static void throw_no_rotation();

    Rotation rotation_;
    double defect_ = 0.0;
    Error error_ = Error::none;
};

/// Kinds of diagnostic, in the order in which they are reported.
enum class DiagnosticKind : std::uint8_t {
    normalized,
    gimbal_lock,
    near_gimbal_lock,
    half_turn,
    infinite,
    identity_axis,
    method_error,
    coarse_step,
    beyond
};
inline constexpr std::size_t diagnostic_kind_count = static_cast<std::size_t>(DiagnosticKind::beyond) + 1;

/// The kind's name as it stands in the `notes` column, such as "gimbal-lock".
[[nodiscard]] std::string_view name_of(DiagnosticKind kind) noexcept;

/// A set of kinds.
class DiagnosticSet {
public:
    constexpr DiagnosticSet() noexcept = default;
    constexpr DiagnosticSet(DiagnosticKind kind, bool present) noexcept
        : bits_(static_cast<std::uint16_t>(present ? bit(kind) : 0U)) {}

    [[nodiscard]] constexpr bool has(DiagnosticKind kind) const noexcept { return (bits_ & bit(kind)) != 0U; }
    [[nodiscard]] constexpr bool empty() const noexcept { return bits_ == 0U; }
    constexpr DiagnosticSet& operator|=(DiagnosticSet other) noexcept {
        bits_ = static_cast<std::uint16_t>(bits_ | other.bits_);
        return *this;
    }

private:
    static constexpr unsigned bit(DiagnosticKind kind) noexcept { return 1U << static_cast<unsigned>(kind); }
    static_assert(diagnostic_kind_count <= 16, "a kind is a bit");
    std::uint16_t bits_ = 0;
};

/// How close an attitude is to where a set of parameters is singular.
struct Sensitivity {
    /// Angle in radians to the nearest attitude at which the set is singular; infinite for a set without any.
    double margin = std::numeric_limits<double>::infinity();
    /// Largest singular value of the map from a small rotation (radians) to the parameters (radians where angles).
    double condition = 1.0;
};

/// Attitudes nearer than this (radians) to a half-turn are reported as one.
inline constexpr double half_turn_margin = 1e-15;
/// A condition above this is reported as near gimbal lock.
inline constexpr double near_lock_condition = 1e6;
/// A step of an integration whose error is estimated above this (radians) is reported.
inline constexpr double reported_step_error = 1e-3;
/// A defect above this is reported.
inline constexpr double reported_defect = 1e-6;

} // namespace rotconv
