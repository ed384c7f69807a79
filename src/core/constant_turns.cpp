#include "constant_turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <rotconv/dcm.hpp>

#include "numerics/davenport.hpp"
#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

/// The eigenvector of a symmetric matrix to its largest eigenvalue, as a quaternion: plane rotations until the matrix
/// is diagonal (Jacobi 1846).
Rotation leading_eigenvector(Eigen::Matrix4d matrix) noexcept {
    constexpr int most_sweeps = 30;
    Eigen::Matrix4d vectors = Eigen::Matrix4d::Identity();
    bool diagonal = false;
    for (int sweep = 0; sweep < most_sweeps && !diagonal; ++sweep) {
        diagonal = true;
        for (Eigen::Index i = 0; i < 3; ++i) {
            for (Eigen::Index k = i + 1; k < 4; ++k) {
                const double off = matrix(i, k);
                if (std::fabs(off) <= 0x1p-60 * matrix.diagonal().cwiseAbs().maxCoeff()) {
                    continue;
                }
                diagonal = false;
                const double cotangent = (matrix(k, k) - matrix(i, i)) / (2.0 * off); // of twice the angle
                const double tangent =
                    std::copysign(1.0, cotangent) / (std::fabs(cotangent) + std::sqrt(1.0 + cotangent * cotangent));
                const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
                const double sine = cosine * tangent;
                const auto rotate = [&](auto&& first, auto&& second) {
                    const Eigen::Vector4d old = first;
                    first = cosine * old - sine * second;
                    second = sine * old + cosine * second;
                };
                rotate(matrix.col(i), matrix.col(k));
                Eigen::Matrix4d transposed = matrix.transpose();
                rotate(transposed.col(i), transposed.col(k));
                matrix = transposed;
                rotate(vectors.col(i), vectors.col(k));
            }
        }
    }
    Eigen::Index largest = 0;
    matrix.diagonal().maxCoeff(&largest);
    const Eigen::Vector4d q = vectors.col(largest);
    return Rotation::from_components(q[0], q[1], q[2], q[3]);
}

class MeanRotation {
public:
    void add(const Rotation& rotation) noexcept {
        const Eigen::Vector4d q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
        sum_ += q * q.transpose() / rotation.squared_norm();
    }
    [[nodiscard]] Rotation mean() const noexcept { return leading_eigenvector(sum_); }

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
    const Eigen::Matrix3d& m = products;
    const Davenport<double> k({m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)});
    Eigen::Matrix4d matrix;
    matrix << k.ww, k.wx, k.wy, k.wz, k.wx, k.xx, k.xy, k.xz, k.wy, k.xy, k.yy, k.yz, k.wz, k.xz, k.yz, k.zz;
    return leading_eigenvector(matrix);
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

ConstantTurns with_named_axes(const ConstantTurns& turns, TurnedSide first, std::span<const Rotation> unknown,
                              std::span<const Rotation> known) {
    const auto named = [](const Rotation& rotation) {
        const Dcm rounded = dcm::from_rotation(rotation).array().round();
        const Reading reading = dcm::to_rotation(rounded, 0.0);
        return reading ? *reading : rotation;
    };
    ConstantTurns found;
    if (first == TurnedSide::reference) {
        found.left = named(turns.left);
        found.right = named(right_turn(unknown, found.left, known));
    } else {
        found.right = named(turns.right);
        found.left = named(left_turn(unknown, found.right, known));
    }
    return found;
}

} // namespace rotconv
