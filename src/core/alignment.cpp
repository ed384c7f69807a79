#include <rotconv/alignment.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include <rotconv/dcm.hpp>

#include "numerics/davenport.hpp"
#include "numerics/eigensystem.hpp"
#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Products = Eigen::Map<const Eigen::Matrix<double, 16, 16>>;

constexpr double eps = std::numeric_limits<double>::epsilon();

Vector4d unit(const Rotation& q) noexcept { return Vector4d(q.w(), q.x(), q.y(), q.z()) / std::sqrt(q.squared_norm()); }

Rotation rotation(const Vector4d& q) noexcept { return Rotation::from_components(q[0], q[1], q[2], q[3]); }

/// The matrix of the product q r in the components of r.
Matrix4d product_by(const Vector4d& q) noexcept {
    Matrix4d matrix;
    matrix << q[0], -q[1], -q[2], -q[3], q[1], q[0], -q[3], q[2], q[2], q[3], q[0], -q[1], q[3], -q[2], q[1], q[0];
    return matrix;
}

/// The matrix of e x v in the components of v, for a unit vector e.
Matrix3d cross_by(Index axis) noexcept { return product_by(Vector4d::Unit(axis + 1)).bottomRightCorner<3, 3>(); }

/// The turns on both sides, from the first pair on: with the turn q from the first attitude to another and k from the
/// first known one, k = remainder (turn q turn'), where the remainder is near the identity if the first pair is good.
/// So each number in the sums has the digits of its own size, and small motions keep theirs.
struct BothTurns {
    Rotation remainder;
    Rotation turn;

    /// The matrix of turn q turn' in the components of q.
    [[nodiscard]] Matrix4d turned() const noexcept {
        Matrix4d matrix = Matrix4d::Identity();
        matrix.bottomRightCorner<3, 3>() = dcm::from_rotation(turn);
        return matrix;
    }
};

/// The sum of the squared cosines of the half angles that both turns leave, x' G x where x are the 16 entries of the
/// matrix of `remainder (turn q turn')`, and its derivatives.
class SquaredCosines {
public:
    SquaredCosines(const Products& products, const BothTurns& at) noexcept {
        const Matrix4d left = product_by(unit(at.remainder));
        const Matrix4d right = at.turned();
        const Matrix3d dcm = right.bottomRightCorner<3, 3>();
        Eigen::Matrix<double, 16, 7> x; // the entries, and their derivatives by turns after either
        const auto set = [&x](Index i, const Matrix4d& matrix) { x.col(i) = matrix.reshaped(); };
        const auto turned_vectors = [&](const Matrix3d& by) {
            Matrix4d matrix = Matrix4d::Zero();
            matrix.bottomRightCorner<3, 3>() = by * dcm;
            return Matrix4d(left * matrix);
        };
        set(0, left * right);
        for (Index i = 0; i < 3; ++i) {
            set(1 + i, product_by(Vector4d::Unit(i + 1)) * left * right);
            set(4 + i, turned_vectors(cross_by(i)));
        }
        const Eigen::Matrix<double, 16, 7> y = products.lazyProduct(x);
        const Eigen::Matrix<double, 7, 7> form = x.transpose().lazyProduct(y);
        sum_ = form(0, 0);
        slope_ = form.col(0).tail<6>();
        curvature_ = -form.bottomRightCorner<6, 6>();
        const auto bend = [&](Index i, Index k, const Matrix4d& second) {
            curvature_(i, k) -= second.reshaped().dot(y.col(0));
            curvature_(k, i) = curvature_(i, k);
        };
        for (Index i = 0; i < 3; ++i) {
            curvature_(i, i) += sum_;
            for (Index k = 0; k < 3; ++k) {
                bend(i, 3 + k, product_by(Vector4d::Unit(i + 1)) * turned_vectors(cross_by(k)));
            }
            for (Index k = i; k < 3; ++k) {
                bend(3 + i, 3 + k, turned_vectors(0.5 * (cross_by(i) * cross_by(k) + cross_by(k) * cross_by(i))));
            }
        }
    }

    [[nodiscard]] double sum() const noexcept { return sum_; }
    /// The least second derivative of the sum's negative, halved.
    [[nodiscard]] double least_curvature() const noexcept { return Eigensystem<6>(curvature_).values[0]; }
    /// Newton's step, turned upwards where the sum is not concave; none along what makes no difference.
    [[nodiscard]] Eigen::Matrix<double, 6, 1> step() const noexcept {
        const Eigensystem<6> system(curvature_);
        const double least = 64.0 * eps * curvature_.diagonal().tail<3>().cwiseAbs().sum();
        Eigen::Matrix<double, 6, 1> step = Eigen::Matrix<double, 6, 1>::Zero();
        for (Index i = 0; i < 6; ++i) {
            const double size = std::fabs(system.values[i]);
            if (size > least) {
                step += system.vectors.col(i) * (system.vectors.col(i).dot(slope_) / size);
            }
        }
        constexpr double longest = 0.5;
        return step * std::min(1.0, longest / std::max(step.norm(), longest));
    }

private:
    double sum_ = 0.0;
    Eigen::Matrix<double, 6, 1> slope_;     ///< halved
    Eigen::Matrix<double, 6, 6> curvature_; ///< halved, of the sum's negative
};

struct Start {
    BothTurns turns;
    double sum = 0.0; ///< of the squared cosines
};

/// The best remainder with a turn.
Start start_from(const Products& products, const Rotation& turn) noexcept {
    const Matrix4d turned = BothTurns{{}, turn}.turned();
    Eigen::Matrix<double, 16, 4> x;
    for (Index i = 0; i < 4; ++i) {
        x.col(i) = (product_by(Vector4d::Unit(i)) * turned).reshaped();
    }
    const Eigen::Matrix<double, 16, 4> y = products.lazyProduct(x);
    const Eigensystem<4> system(x.transpose().lazyProduct(y));
    return {{rotation(system.vectors.col(3)), turn}, system.values[3]};
}

struct Peak {
    BothTurns turns;
    SquaredCosines at;
};

/// The turns to which Newton's steps lead.
Peak climb(const Products& products, const Start& start) noexcept {
    constexpr int most_steps = 100;
    Peak peak{start.turns, SquaredCosines(products, start.turns)};
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_steps; ++i) {
        const Eigen::Matrix<double, 6, 1> step = peak.at.step();
        const double length = step.norm();
        constexpr double near = 1e-7; // from here on each step squares what is left, down to the rounding
        if (length == 0.0 || (length < near && length >= 0.5 * last)) {
            break;
        }
        last = length;
        bool higher = false;
        for (double part = 1.0; !higher && part > 1e-6; part *= 0.25) {
            const BothTurns turns{rotation({1.0, part * step[0], part * step[1], part * step[2]}) *
                                      peak.turns.remainder,
                                  rotation({2.0, part * step[3], part * step[4], part * step[5]}) * peak.turns.turn};
            const SquaredCosines at(products, turns);
            if (at.sum() > (1.0 - 16.0 * eps) * peak.at.sum()) {
                peak = {turns, at};
                higher = true;
            }
        }
        if (!higher) {
            break;
        }
    }
    return peak;
}

/// The turn that aligns the vectors sin(theta/2) cos(theta/2) n of the turns from the first pair.
Rotation of_vectors(const Products& products) noexcept {
    const Eigen::Map<const Matrix4d> sums(products.data()); // of k q' times the product of their scalars
    const Matrix4d& m = sums;
    const Davenport<double> k({m(1, 1), m(1, 2), m(1, 3), m(2, 1), m(2, 2), m(2, 3), m(3, 1), m(3, 2), m(3, 3)});
    Matrix4d matrix;
    matrix << k.ww, k.wx, k.wy, k.wz, k.wx, k.xx, k.xy, k.xz, k.wy, k.xy, k.yy, k.yz, k.wz, k.xz, k.yz, k.zz;
    return rotation(Eigensystem<4>(matrix).vectors.col(3));
}

} // namespace

void MeanTurn::add(const Rotation& turn) noexcept {
    if (count_ == 0.0) {
        first_ = turn;
    }
    const Rotation q = first_.inverse() * turn;
    const double square = q.squared_norm();
    const Vector3d v(q.x(), q.y(), q.z());
    count_ += 1.0;
    products_ += v * (q.w() / square);
    squares_ += v * v.transpose() / square;
}

Matrix4d MeanTurn::squared_sines() const noexcept {
    Matrix4d matrix;
    matrix << squares_.trace(), -products_.transpose(), -products_, count_ * Matrix3d::Identity() - squares_;
    return matrix;
}

Rotation MeanTurn::mean() const noexcept { return first_ * rotation(Eigensystem<4>(squared_sines()).vectors.col(0)); }

double MeanTurn::rms() const noexcept {
    if (count_ == 0.0) {
        return 0.0;
    }
    const double square = std::clamp(Eigensystem<4>(squared_sines()).values[0] / count_, 0.0, 1.0);
    return 2.0 * angle_of(std::sqrt(1.0 - square), std::sqrt(square), AngleUnit::radians).hi;
}

void Alignment::add(const Rotation& attitude, const Rotation& known) noexcept {
    if (mean_.count_ == 0.0) {
        first_attitude_ = attitude;
        first_known_ = known;
    }
    if (side_ != AlignedSide::both) {
        mean_.add(side_ == AlignedSide::body ? attitude.inverse() * known : known * attitude.inverse());
        return;
    }
    mean_.count_ += 1.0;
    const Vector4d q = unit(first_attitude_.inverse() * attitude);
    const Vector4d k = unit(first_known_.inverse() * known);
    Eigen::Matrix<double, 16, 1> g;
    for (Index i = 0; i < 4; ++i) {
        g.segment<4>(4 * i) = q[i] * k;
    }
    Eigen::Map<Eigen::Matrix<double, 16, 16>> products(products_.data());
    products += g * g.transpose();
}

std::optional<ConstantTurns> Alignment::turns() const noexcept {
    const Found found = find();
    return found.determined ? std::optional(found.turns) : std::nullopt;
}

Alignment::Found Alignment::find() const noexcept {
    if (mean_.count_ == 0.0) {
        return {};
    }
    if (side_ == AlignedSide::both) {
        return find_both();
    }
    if (side_ == AlignedSide::yaw) {
        return find_yaw();
    }
    if (side_ == AlignedSide::first) {
        return {{mean_.first_, {}}, true};
    }
    const Vector4d values = Eigensystem<4>(mean_.squared_sines()).values;
    const bool determined = values[1] - values[0] > 64.0 * eps * mean_.count_;
    const Rotation mean = mean_.mean();
    return {side_ == AlignedSide::body ? ConstantTurns{{}, mean} : ConstantTurns{mean, {}}, determined};
}

Alignment::Found Alignment::find_yaw() const noexcept {
    Eigen::Matrix<double, 4, 2> plane; // the identity and the half-turn about z, after the first turn
    plane << unit(mean_.first_.inverse()), unit(mean_.first_.inverse() * Rotation::near_unit(0.0, 0.0, 0.0, 1.0));
    const Eigensystem<2> system(plane.transpose() * mean_.squared_sines() * plane);
    return {{Rotation::from_components(system.vectors(0, 0), 0.0, 0.0, system.vectors(1, 0)), {}},
            system.values[1] - system.values[0] > 64.0 * eps * mean_.count_};
}

Alignment::Found Alignment::find_both() const noexcept {
    const Products products(products_.data());
    const double count = mean_.count_;
    Peak peak = climb(products, start_from(products, of_vectors(products)));
    constexpr double good = 0.99;
    constexpr std::size_t tried = 8;
    if (peak.at.sum() < good * count) { // there may be a higher one: from the 24 rotations of the axes one is near
        constexpr std::array components{0.0, 1.0, -1.0};
        std::array<Start, 24> starts;
        auto next = starts.begin();
        for (std::size_t i = 1; i < 81; ++i) {
            const Vector4d q(components.at(i / 27), components.at(i / 9 % 3), components.at(i / 3 % 3),
                             components.at(i % 3));
            if (rotation(q).sign() > 0.0 && q.squaredNorm() != 3.0) {
                *next++ = start_from(products, rotation(q));
            }
        }
        std::ranges::sort(starts, std::greater(), &Start::sum);
        for (const Start& start : std::span(starts).first(tried)) {
            const Peak other = climb(products, start);
            peak = other.at.sum() > peak.at.sum() ? other : peak;
        }
    }
    // Errors alone give a curvature of about what is left over the root of the count.
    const double left = count - peak.at.sum() + 64.0 * eps * count;
    return {
        {first_known_ * peak.turns.remainder * peak.turns.turn * first_attitude_.inverse(), peak.turns.turn.inverse()},
        peak.at.least_curvature() * std::sqrt(count) > 4.0 * left};
}

} // namespace rotconv
