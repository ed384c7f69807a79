#pragma once

#include <array>
#include <cmath>

namespace rotconv {

/// The one home of a rotation: a nonzero quaternion (w, x, y, z), Hamilton product, active, body to reference
/// (`v_ref = R_ref_body * v_body`).
///
/// It is *not* normalised: every representation divides by the norm itself, which saves half an eps everywhere. What
/// always holds:
/// - all four components are finite;
/// - the largest magnitude lies in [1/2, 1), reached by an exact scaling with a power of two, so that no square of it
///   overflows and the norm lies in [1/2, 2);
/// - the sign is canonical: w > 0, or w = 0 and the first nonzero of x, y, z is positive; no component is -0.
class Rotation {
public:
    /// The identity.
    constexpr Rotation() noexcept = default;

    /// The rotation of a finite nonzero quaternion of any norm and either sign. Exact, but for components more than
    /// 2^1074 times smaller than the largest, which become 0.
    /// @pre all components finite, one of them not 0 (the representations check what comes from outside).
    static Rotation from_components(double w, double x, double y, double z) noexcept;

    [[nodiscard]] double w() const noexcept { return q_[0]; }
    [[nodiscard]] double x() const noexcept { return q_[1]; }
    [[nodiscard]] double y() const noexcept { return q_[2]; }
    [[nodiscard]] double z() const noexcept { return q_[3]; }
    /// Component of the vector part along `axis` 0, 1, 2.
    [[nodiscard]] double along(int axis) const noexcept { return q_[static_cast<std::size_t>(axis) + 1]; }

    /// |q|^2, in [1/4, 4).
    [[nodiscard]] double squared_norm() const noexcept {
        return (q_[0] * q_[0] + q_[1] * q_[1]) + (q_[2] * q_[2] + q_[3] * q_[3]);
    }

    /// |(x, y, z)| with full relative accuracy at any size: 0 only when the vector part is exactly 0.
    [[nodiscard]] double vector_length() const noexcept {
        const double square = squared_vector_length();
        return square > 1e-280 ? std::sqrt(square) : tiny_vector_length();
    }

    /// |(x, y, z)|^2; loses digits below 1e-280, where vector_length() does not.
    [[nodiscard]] double squared_vector_length() const noexcept {
        return (q_[1] * q_[1] + q_[2] * q_[2]) + q_[3] * q_[3];
    }

    /// The inverse rotation (reference to body). Exact.
    [[nodiscard]] Rotation inverse() const noexcept;

private:
    [[nodiscard]] double tiny_vector_length() const noexcept;
    void make_sign_canonical() noexcept;

    std::array<double, 4> q_{0.5, 0.0, 0.0, 0.0};
};

} // namespace rotconv
