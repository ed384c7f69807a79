#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <rotconv/angle.hpp>
#include <rotconv/reading.hpp>

namespace rotconv {

/// One of the 24 Euler sequences. Upper case, such as "ZYX", means turns about the moving body axes in that order
/// (intrinsic); lower case, such as "xyz", means turns about the fixed reference axes (extrinsic). Neighbouring letters
/// differ. A minus sign before a letter negates that angle: "Z-Y-X" is R_Z(a) R_Y(-b) R_X(-c).
class EulerSequence {
public:
    /// XYZ.
    constexpr EulerSequence() noexcept = default;
    /// A literal, such as "ZYX", which the compiler checks.
    template <std::size_t size>
    consteval EulerSequence(const char (&letters)[size]) // NOLINT(*-avoid-c-arrays, google-explicit-constructor)
    {
        const auto parsed = parse({letters, size - 1});
        if (!parsed) {
            an_euler_sequence_has_three_letters_of_XYZ_or_xyz_and_no_two_equal_neighbours();
        }
        *this = *parsed;
    }

    /// The sequence of three letters, or nothing if they do not name one. Digits are upper-case letters, which hyphens
    /// may part: 321, 3-1-3.
    [[nodiscard]] static constexpr std::optional<EulerSequence> parse(std::string_view letters) noexcept {
        EulerSequence sequence;
        const bool is_digits = !letters.empty() && letters[0] >= '1' && letters[0] <= '3';
        for (std::size_t i = 0; i < 3; ++i) {
            if (letters.starts_with('-')) {
                sequence.signs_[i] = is_digits ? 1 : -1;
                letters.remove_prefix(1);
            }
            if (letters.empty()) {
                return std::nullopt;
            }
            if (i == 0) {
                sequence.intrinsic_ = letters[0] < 'a';
            }
            const int axis = letters[0] - (is_digits ? '1' : sequence.intrinsic_ ? 'X' : 'x');
            if (axis < 0 || axis > 2 || (i > 0 && axis == sequence.axes_[i - 1])) {
                return std::nullopt;
            }
            sequence.axes_[i] = static_cast<std::int8_t>(axis);
            letters.remove_prefix(1);
        }
        return letters.empty() ? std::optional(sequence) : std::nullopt;
    }

    /// All 24 without signs, intrinsic first.
    [[nodiscard]] static std::array<EulerSequence, 24> all() noexcept;

    /// The same axes, with those angles negated.
    [[nodiscard]] constexpr EulerSequence with_signs(bool first, bool second, bool third) const noexcept {
        EulerSequence sequence = *this;
        sequence.signs_ = {std::int8_t(first ? -1 : 1), std::int8_t(second ? -1 : 1), std::int8_t(third ? -1 : 1)};
        return sequence;
    }

    /// The letters, which parse() reads.
    [[nodiscard]] std::string text() const;
    /// The axis (0, 1, 2) of the first, second or third turn (`position` 0, 1, 2).
    [[nodiscard]] constexpr int axis(std::size_t position) const noexcept { return axes_[position]; }
    /// -1 if that angle is negated, else +1.
    [[nodiscard]] constexpr double sign(std::size_t position) const noexcept { return signs_[position]; }
    [[nodiscard]] constexpr bool has_signs() const noexcept { return signs_[0] + signs_[1] + signs_[2] < 3; }
    [[nodiscard]] constexpr bool intrinsic() const noexcept { return intrinsic_; }
    /// True if the first and third axis are the same (proper Euler angles), false if all three differ (Tait-Bryan
    /// angles).
    [[nodiscard]] constexpr bool proper() const noexcept { return axes_[0] == axes_[2]; }

    friend constexpr bool operator==(const EulerSequence&, const EulerSequence&) noexcept = default;

private:
    static void an_euler_sequence_has_three_letters_of_XYZ_or_xyz_and_no_two_equal_neighbours(); // the compiler says it

    std::array<std::int8_t, 3> axes_{0, 1, 2};
    std::array<std::int8_t, 3> signs_{1, 1, 1};
    bool intrinsic_ = true;
};

/// Roll, pitch and yaw: turns about the fixed x, y and z axes (Stuelpnagel's phi, theta, psi).
inline constexpr EulerSequence roll_pitch_yaw = "xyz";

/// Three angles in the order of their sequence; any finite size on input. Sequence and unit are always given.
struct EulerAngles {
    EulerAngles(const Eigen::Vector3d& values, EulerSequence order, AngleUnit angle_unit) noexcept // NOLINT(*-by-value)
        : angles(values), sequence(order), unit(angle_unit) {}
    // NOLINTNEXTLINE(*-member-init): it delegates
    EulerAngles(const DynamicMatrix auto& values, EulerSequence order, AngleUnit angle_unit)
        : EulerAngles(sized<Eigen::Vector3d>(values), order, angle_unit) {}

    Eigen::Vector3d angles;
    EulerSequence sequence;
    AngleUnit unit;
};

/// Euler angles of every sequence (Stuelpnagel 1964, section 6, for roll-pitch-yaw). Singular at gimbal lock, where the
/// middle angle is +-pi/2 (three different axes) or 0 or pi (first axis = third): only the sum or difference of the
/// other two angles is defined there.
namespace euler {

/// By default, attitudes nearer to gimbal lock than this (radians), which is rounding, are treated as locked.
inline constexpr double default_lock_margin = 1e-15;

/// The product of three half-angle quaternions, q1 q2 q3 of an intrinsic sequence and q3 q2 q1 of an extrinsic one.
/// Angles of any finite size. Error: not_finite. Worst error found: 3.41 eps.
[[nodiscard]] Reading to_rotation(const EulerAngles& value) noexcept;

/// First and third angle in (-pi, pi], middle in [-pi/2, pi/2] or [0, pi]; these are the ranges of the angles as they
/// are returned, signs of the sequence included.
///
/// With a, b, c, d of Bernardes and Viollet (2022), where a + ib = C e^(i s) and c + id = S e^(i t) hold half the sum
/// and difference s, t of the outer angles: these are the angles atan2(imaginary, real) of (a + ib)(c +- id), and the
/// middle one is twice atan2(S, C), less pi/2 for three different axes. Accuracy does not depend on the distance from
/// gimbal lock, and needs no threshold. The threshold `lock_margin` makes angles readable: if the margin is at most
/// `lock_margin`, the third angle is 0, the middle one is at its limit, and the first takes up the rest, which causes
/// an error of up to `lock_margin` radians. With 0 only exact gimbal lock is special; from pi/2 on all attitudes are
/// locked.
[[nodiscard]] EulerAngles from_rotation(const Rotation& rotation, EulerSequence sequence,
                                        AngleUnit unit = AngleUnit::radians,
                                        double lock_margin = default_lock_margin) noexcept;

/// gimbal_lock, near_gimbal_lock.
[[nodiscard]] DiagnosticSet diagnostics(const Rotation& rotation, EulerSequence sequence,
                                        double lock_margin = default_lock_margin) noexcept;

/// Margin pi/2 - |middle|, or the smaller of middle and pi - middle; condition 1/(sqrt 2 sin(margin/2)).
[[nodiscard]] Sensitivity sensitivity(const Rotation& rotation, EulerSequence sequence) noexcept;

/// The rates of the three angles, in the unit of the angles a second. For roll, pitch and yaw they solve the 3x3 system
/// of Stuelpnagel, section 6; the other sequences differ by names and signs of the axes. The rates contain a division
/// by the cosine (first axis = third: the sine) of the middle angle, and are not finite at gimbal lock.
[[nodiscard]] Eigen::Vector3d rate(const EulerAngles& value, const Eigen::Vector3d& w,
                                   Frame frame = Frame::body) noexcept;

/// The inverse of rate(), regular everywhere: the sum of the three axes of the turns, each times its angle's rate.
/// Rates in the unit of the angles a second, result in rad/s.
[[nodiscard]] Eigen::Vector3d angular_velocity(const EulerAngles& value, const Eigen::Vector3d& rates,
                                               Frame frame = Frame::body) noexcept;

} // namespace euler
} // namespace rotconv
