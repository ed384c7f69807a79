#include "constant_turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <rotconv/dcm.hpp>

#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

class MeanRotation {
public:
    void add(const Rotation& rotation) noexcept {
        const Eigen::Vector4d q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
        sum_ += q * q.transpose() / rotation.squared_norm();
    }
    [[nodiscard]] Rotation mean() const {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(sum_);
        const Eigen::Vector4d q = solver.eigenvectors().col(3);
        return Rotation::near_unit(q[0], q[1], q[2], q[3]);
    }

private:
    Eigen::Matrix4d sum_ = Eigen::Matrix4d::Zero();
};

Rotation left_turn(std::span<const Rotation> unknown, const Rotation& right, std::span<const Rotation> known) {
    MeanRotation found;
    for (std::size_t i = 0; i < known.size(); ++i) {
        found.add(known[i] * (unknown[i] * right).inverse());
    }
    return found.mean();
}

Rotation right_turn(std::span<const Rotation> unknown, const Rotation& left, std::span<const Rotation> known) {
    MeanRotation found;
    for (std::size_t i = 0; i < known.size(); ++i) {
        found.add((left * unknown[i]).inverse() * known[i]);
    }
    return found.mean();
}

/// The right turn S of both: K_i' K_j = S' (U_i' U_j) S, so that S' turns the vectors of the relative turns.
Rotation aligned(std::span<const Rotation> unknown, std::span<const Rotation> known) {
    const auto rows = spread_rows(known, 24);
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    for (const std::size_t i : rows) {
        for (const std::size_t j : rows) {
            products += relative_vector(unknown[i], unknown[j]) * relative_vector(known[i], known[j]).transpose();
        }
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d u = svd.matrixU();
    const Eigen::Matrix3d v = svd.matrixV();
    const double sign = (u * v.transpose()).determinant();
    const Reading right = dcm::to_rotation(u * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * v.transpose());
    return right ? *right : Rotation();
}

} // namespace

Eigen::Vector3d relative_vector(const Rotation& a, const Rotation& b) noexcept {
    const Rotation turn = a.inverse() * b;
    return Eigen::Vector3d(turn.x(), turn.y(), turn.z()) * (turn.w() / turn.squared_norm());
}

std::vector<std::size_t> spread_rows(std::span<const Rotation> attitudes, std::size_t count) {
    std::vector<std::size_t> rows{0};
    std::vector<double> nearest(attitudes.size(), std::numeric_limits<double>::infinity());
    while (rows.size() < std::min(count, attitudes.size())) {
        for (std::size_t i = 0; i < attitudes.size(); ++i) {
            nearest[i] = std::min(nearest[i], angle_of(attitudes[i] * attitudes[rows.back()].inverse()));
        }
        const auto farthest = std::ranges::max_element(nearest);
        rows.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
    }
    return rows;
}

ConstantTurns constant_turns(TurnedSide side, std::span<const Rotation> unknown, std::span<const Rotation> known) {
    if (side == TurnedSide::body) {
        return {{}, right_turn(unknown, {}, known)};
    }
    if (side == TurnedSide::reference) {
        return {left_turn(unknown, {}, known), {}};
    }
    ConstantTurns turns;
    turns.right = aligned(unknown, known);
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
        turns.left = left_turn(unknown, turns.right, known);
        const Rotation right = right_turn(unknown, turns.left, known);
        const double moved = angle_of(right * turns.right.inverse());
        turns.right = right;
        if (moved < 1e-9) { // exact rows are there at once
            break;
        }
    }
    return turns;
}

LargestAngle largest_angle(const ConstantTurns& turns, std::span<const Rotation> unknown,
                           std::span<const Rotation> known) noexcept {
    LargestAngle largest;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double angle = angle_of(turns.left * unknown[i] * turns.right * known[i].inverse());
        if (angle > largest.angle) {
            largest = {angle, i};
        }
    }
    return largest;
}

ConstantTurns with_named_axes(const ConstantTurns& turns, double within) noexcept {
    const auto named = [within](const Rotation& rotation) {
        const Dcm rounded = dcm::from_rotation(rotation).array().round();
        const Reading reading = dcm::to_rotation(rounded, 0.0);
        return reading && angle_of(*reading * rotation.inverse()) <= within ? *reading : rotation;
    };
    return {named(turns.left), named(turns.right)};
}

} // namespace rotconv
