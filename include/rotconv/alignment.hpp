#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include <rotconv/rotation.hpp>

namespace rotconv {

/// Constant rotations on the sides of attitudes, for example those that make them known ones.
struct ConstantRotations {
    Rotation left{};
    Rotation right{};

    /// left attitude right.
    Rotation operator()(const Rotation& attitude) const noexcept { return left * attitude * right; }
    /// How many of them are not the identity.
    [[nodiscard]] int count() const noexcept { return (left.is_identity() ? 0 : 1) + (right.is_identity() ? 0 : 1); }
};

/// The mean of rotations: the one from which the sum of the squared sines of the half angles is least, the eigenvector
/// of the sum of q q' (Markley, Cheng, Crassidis and Oshman, "Averaging Quaternions", 2007). The sums are relative to
/// the first rotation, so that rotations that are nearly equal keep their digits, however many they are. Constant
/// memory.
class MeanRotation {
public:
    void add(const Rotation& rotation) noexcept;

    /// The identity if there are none.
    [[nodiscard]] Rotation mean() const noexcept;
    /// Root mean square angle of the rotations from their mean, radians: that whose squared half sine is the mean of
    /// theirs, which is the same to a part of angle^2/24.
    [[nodiscard]] double rms() const noexcept;

private:
    friend class Alignment;
    /// The quadratic form of the sum of squared sines in the components of a rotation after the first.
    [[nodiscard]] Eigen::Matrix4d squared_sines() const noexcept;

    // Sums over the unit quaternions (w, v) from the first rotation to each.
    double count_ = 0.0;
    Rotation first_;
    Eigen::Vector3d products_ = Eigen::Vector3d::Zero(); ///< sum of w v
    Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();  ///< sum of v v'
};

/// The sides of the attitudes on which constant rotations are estimated.
enum class AlignedSide : std::uint8_t {
    body,      ///< right
    reference, ///< left
    both,
    yaw,   ///< left, about the reference's z
    first, ///< left, that of the first pair
};

/// Finds the constant rotations that bring attitudes to known ones: those that leave the least sum of the squared sines
/// of the half angles. Constant memory. Worst error found with rotations that are the same in all pairs: 2.9 eps, on
/// both sides 5.6 eps of attitudes all around, and 1 eps over the size of smaller motions, in radians; limits 4, 8, 2.
/// The sums of both sides lose more over many pairs: 9.5 eps found with 100,000, limit 16.
class Alignment {
public:
    explicit Alignment(AlignedSide side) : side_(side) {}

    void add(const Rotation& attitude, const Rotation& known) noexcept;

    /// Nothing if the pairs do not determine them: there are no pairs; others leave as little; or, on both
    /// sides, the attitudes differ only by rotations about one axis, except for what is left.
    [[nodiscard]] std::optional<ConstantRotations> rotations() const;
    /// The same; if the pairs do not determine them, some of those that leave the least.
    [[nodiscard]] ConstantRotations some_rotations() const { return find().rotations; }

private:
    struct Found {
        ConstantRotations rotations;
        bool determined = false;
    };
    [[nodiscard]] Found find() const;
    [[nodiscard]] Found find_yaw() const noexcept;
    [[nodiscard]] Found find_both() const;

    AlignedSide side_;
    MeanRotation mean_; ///< mean of the pairs' constant rotations; only their count for both sides
    Rotation first_attitude_;
    Rotation first_known_;
    /// The sum of g g', column by column, over the rotations from the first pair to each, unit quaternions q and k: the
    /// entries of g are those of k q', column by column.
    std::array<double, 256> products_{};
};

} // namespace rotconv
