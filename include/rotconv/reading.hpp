#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include <rotconv/rotation.hpp>

namespace rotconv {

/// Why numbers do not describe a rotation, or cannot be carried on. See message().
enum class Error : std::uint8_t {
    none,
    not_finite,      ///< a number is nan or infinite
    overflow,        ///< finite numbers whose result is too large for a double
    zero_quaternion, ///< all four components are 0
    zero_axis,       ///< an axis of length 0 with an angle that is not 0
    not_proper,      ///< a matrix with det <= 0: singular, or a reflection
    rank_deficient,  ///< two columns that do not span a plane, or a matrix of nearly rank one
    defect,          ///< further from a rotation than the tolerance allows
    singular,        ///< the representation has no rates at this attitude, or a motion has come too near to one
    coarse_step,     ///< the body may turn by more in one step than the representation can follow
    time_order,      ///< not at least 1e-100 s later than the sample before
    past_half_turn,  ///< the body may have turned by half a turn or more between two samples
    ended,           ///< an earlier row of the propagation has failed
};

/// The error in words, without the numbers and without a full stop.
[[nodiscard]] std::string_view message(Error error) noexcept;

/// The largest defect that is accepted by default, here and by the program.
inline constexpr double default_tolerance = 1e-3;
/// The tolerance that accepts every defect.
inline constexpr double any_defect = std::numeric_limits<double>::infinity();

/// The result of reading numbers: a rotation, or an error that says why there is none. Tests as true if there is a
/// rotation.
class Reading {
public:
    Reading(const Rotation& rotation, double defect = 0.0) noexcept : rotation_(rotation), defect_(defect) {}
    /// @throw std::logic_error if the error is Error::none
    Reading(Error error, double defect = 0.0) : defect_(defect), error_(error) {
        if (error == Error::none) [[unlikely]] {
            throw_no_rotation();
        }
    }

    [[nodiscard]] explicit operator bool() const noexcept { return error_ == Error::none; }
    /// The rotation; of a temporary by value, which a reference may outlive.
    /// @throw std::logic_error if there is none
    [[nodiscard]] const Rotation& operator*() const& { return *operator->(); }
    // NOLINTNEXTLINE(readability-make-member-function-const): of a temporary
    [[nodiscard]] Rotation operator*() && { return *operator->(); }
    [[nodiscard]] const Rotation* operator->() const {
        if (error_ != Error::none) [[unlikely]] {
            throw_no_rotation();
        }
        return &rotation_;
    }
    /// Error::none if there is a rotation.
    [[nodiscard]] Error error() const noexcept { return error_; }
    /// How far the numbers were from describing a rotation exactly: | |q| - 1 | of a quaternion, the largest singular
    /// value of M - (polar factor of M) of a matrix, and 0 of other representations and of other errors than
    /// Error::defect. Up to `reported_defect` it may be an upper bound.
    [[nodiscard]] double defect() const noexcept { return defect_; }

private:
    [[noreturn]] static void throw_no_rotation();

    Rotation rotation_;
    double defect_ = 0.0;
    Error error_ = Error::none;
};

/// Kinds of diagnostic, in the order in which they are reported.
enum class DiagnosticKind : std::uint8_t {
    normalized,       ///< the numbers were not a rotation by more than `reported_defect`
    axis_length,      ///< an axis not of length 1 by more than `reported_axis_defect`; it has the name of `normalized`
    large_angle,      ///< an angle in radians above `reported_angle`, or a velocity above `reported_velocity`
    gimbal_lock,      ///< within the lock margin: the third Euler angle is set to 0
    near_gimbal_lock, ///< a condition above `near_lock_condition`
    half_turn,        ///< within `half_turn_margin`: the sign of the axis is a convention
    infinite,         ///< a number of cayley is infinite
    identity_axis,    ///< the identity: the axis is a convention
    method_error,     ///< a published method's result is off by more than 1e-6 rad
    coarse_step,      ///< an estimated error of a step above `reported_step_error`
    beyond            ///< an angle above ComparisonSettings::within
};
inline constexpr std::size_t diagnostic_kind_count = static_cast<std::size_t>(DiagnosticKind::beyond) + 1;
inline constexpr auto all_diagnostic_kinds = [] {
    std::array<DiagnosticKind, diagnostic_kind_count> kinds{};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        kinds.at(i) = static_cast<DiagnosticKind>(i);
    }
    return kinds;
}();

/// The kind's name in the `notes` column, such as "gimbal-lock".
[[nodiscard]] std::string_view name_of(DiagnosticKind kind) noexcept;

/// A set of the values of an enumeration.
template <class Enum> class EnumSet {
public:
    constexpr EnumSet() noexcept = default;
    constexpr EnumSet(std::initializer_list<Enum> members) noexcept {
        for (const Enum member : members) {
            *this |= {member, true};
        }
    }
    /// The member alone if it is present, otherwise the empty set.
    constexpr EnumSet(Enum member, bool present) noexcept
        : bits_(static_cast<std::uint16_t>(present ? 1U << static_cast<unsigned>(member) : 0U)) {}

    [[nodiscard]] constexpr bool has(Enum member) const noexcept {
        return (bits_ >> static_cast<unsigned>(member) & 1U) != 0;
    }
    [[nodiscard]] constexpr bool has_all(EnumSet others) const noexcept { return (others.bits_ & ~bits_) == 0; }
    [[nodiscard]] constexpr bool empty() const noexcept { return bits_ == 0; }
    [[nodiscard]] constexpr int count() const noexcept { return std::popcount(bits_); }
    constexpr EnumSet& operator|=(EnumSet other) noexcept {
        bits_ = static_cast<std::uint16_t>(bits_ | other.bits_);
        return *this;
    }

private:
    std::uint16_t bits_ = 0;
};

using DiagnosticSet = EnumSet<DiagnosticKind>;
static_assert(diagnostic_kind_count <= 16, "a kind is a bit");

/// How close an attitude is to a singularity of a representation.
struct Sensitivity {
    /// Angle in radians to the nearest attitude at which the representation is singular; infinite if there is none.
    double margin = std::numeric_limits<double>::infinity();
    /// Largest singular value of the map from a small rotation (radians) to the numbers (angles in radians).
    double condition = 1.0;
};

/// A defect above this is reported. What four decimal places leave is below.
inline constexpr double reported_defect = 2e-4;
/// An axis whose length differs from 1 by more than this is reported.
inline constexpr double reported_axis_defect = 1e-3;
/// An angle, or the norm of a rotation vector, that is read in radians and is larger than this is reported.
inline constexpr double reported_angle = 2.0 * std::numbers::pi;
/// An angular velocity that is read in radians a second and is larger than this is reported.
inline constexpr double reported_velocity = 35.0;

/// What is unusual about the numbers of an attitude; 0 if nothing is.
struct UnusualNumbers {
    double defect = 0.0;  ///< a defect that is reported, or | length - 1 | of an axis
    double angle = 0.0;   ///< the largest angle or angular velocity that is reported
    bool of_axis = false; ///< the defect is an axis's

    /// The figure of a diagnostic of this kind; 0 if there is none, or the kind is not about numbers.
    [[nodiscard]] constexpr double figure_of(DiagnosticKind kind) const noexcept {
        return kind == DiagnosticKind::large_angle                                            ? angle
               : kind == (of_axis ? DiagnosticKind::axis_length : DiagnosticKind::normalized) ? defect
                                                                                              : 0.0;
    }
};

/// What a report says about one of several representations of its result.
struct PartReport {
    DiagnosticSet diagnostics{};
    Sensitivity sensitivity{};
};

/// What a report says about the second attitude of a row.
struct ReferenceReport {
    double defect = 0.0;
    UnusualNumbers unusual{};
};

/// The report on one row.
struct RowReport {
    std::size_t row = 0; ///< its index among the rows of the run
    Error error = Error::none;
    std::size_t at_fault = 0; ///< what has the error: 0 the first attitude, above it one of `references`
    DiagnosticSet diagnostics{};
    /// Of the attitude with the error, otherwise of the first; below `reported_defect` and without
    /// ConversionSettings::sensitivity only an upper bound.
    double defect = 0.0;
    Sensitivity sensitivity{}; ///< set if the result has diagnostics, or with ConversionSettings::sensitivity
    double deviation = 0.0;    ///< radians, or a comparison's unit: the angle of method_error, coarse_step and beyond
    UnusualNumbers unusual{};  ///< in the first attitude
    std::array<ReferenceReport, 2> references{}; ///< the second attitude, or both between which it is interpolated
    std::vector<PartReport> parts{};             ///< one for each representation of the result, if there are several

    /// Adds the diagnostics of the unusual numbers of the first attitude.
    void report_numbers() noexcept {
        for (const DiagnosticKind kind : all_diagnostic_kinds) {
            diagnostics |= {kind, unusual.figure_of(kind) > 0.0};
        }
    }
};

/// Attitudes nearer than this (radians) to a half-turn are reported as a half-turn.
inline constexpr double half_turn_margin = 1e-15;
/// Euler angles with a larger condition are reported as near gimbal lock.
inline constexpr double near_lock_condition = 1e6;
/// An integration step whose estimated error (radians) is above this is reported.
inline constexpr double reported_step_error = 1e-3;

} // namespace rotconv
