#include <rotconv/alignment.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <rotconv/dcm.hpp>

#include "../numerics/davenport.hpp"
#include "../numerics/eigensystem.hpp"
#include "../representations/rotation_angle.hpp"

namespace rotconv {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Entries = Eigen::Matrix<double, 16, 1>;
using Step = Eigen::Matrix<double, 6, 1>; ///< after the remainder, half an angle, and after the change, an angle
using Products = Eigen::Map<const Eigen::Matrix<double, 16, 16>>;

constexpr double eps = std::numeric_limits<double>::epsilon();

Rotation rotation(const Vector4d& q) noexcept { return Rotation::from_components(q[0], q[1], q[2], q[3]); }

/// The matrix of the product q r in the components of r.
Matrix4d product_by(const Vector4d& q) noexcept {
    Matrix4d matrix;
    matrix << q[0], -q[1], -q[2], -q[3], q[1], q[0], -q[3], q[2], q[2], q[3], q[0], -q[1], q[3], -q[2], q[1], q[0];
    return matrix;
}

/// The constant rotations on both sides, from the first pair on: with the rotation q from the first attitude to another
/// and k from the first known one, k = remainder (change q change'), where the remainder is near the identity if the
/// first pair is good. So each number in the sums has the digits of its own size, and small motions keep theirs. With
/// them the sum of the squared cosines of the half angles that they leave, x' G x where x are the 16 entries of the
/// matrix of `remainder (change q change')` in the components of q, and its derivatives.
class BothSides {
public:
    BothSides(const Products& products, const Rotation& remainder, const Rotation& change) noexcept
        : remainder_(remainder), change_(change) {
        const Matrix4d left = product_by(unit(remainder));
        const Matrix4d right = conjugation_by(change);
        // Factors before and after `left`: 1, and the derivatives by rotations after the remainder and after the
        // change.
        const auto outer = [](Index i) { return product_by(Vector4d::Unit(i < 4 ? i : 0)); };
        const auto inner = [](Index i) {
            Matrix4d matrix = product_by(Vector4d::Unit(i < 4 ? 0 : i - 3));
            if (i >= 4) {
                matrix.row(0).setZero();
                matrix.col(0).setZero();
            }
            return matrix;
        };
        const auto entries = [&](Index i, Index k) -> Entries {
            const Matrix4d before = outer(i) * outer(k) + outer(k) * outer(i);
            const Matrix4d after = inner(i) * inner(k) + inner(k) * inner(i);
            const Matrix4d product = 0.25 * before * left * after * right;
            return product.reshaped();
        };
        Eigen::Matrix<double, 16, 7> x;
        for (Index i = 0; i < 7; ++i) {
            x.col(i) = entries(0, i);
        }
        const Eigen::Matrix<double, 16, 7> y = products.lazyProduct(x);
        sum_ = x.col(0).dot(y.col(0));
        for (Index i = 0; i < 6; ++i) {
            slope_[i] = x.col(1 + i).dot(y.col(0));
            for (Index k = i; k < 6; ++k) {
                curvature_(i, k) = curvature_(k, i) =
                    -x.col(1 + i).dot(y.col(1 + k)) - entries(1 + i, 1 + k).dot(y.col(0));
            }
        }
    }

    /// With a change and the best remainder.
    BothSides(const Products& products, const Rotation& change) noexcept
        : BothSides(products, best_remainder(products, change), change) {}

    [[nodiscard]] const Rotation& remainder() const noexcept { return remainder_; }
    [[nodiscard]] const Rotation& change() const noexcept { return change_; }
    [[nodiscard]] double sum() const noexcept { return sum_; }
    /// The least second derivative of the sum's negative, halved.
    [[nodiscard]] double least_curvature() const noexcept { return Eigensystem<6>(curvature_).values[0]; }

    /// Newton's step, turned upwards where the sum is not concave; none along what makes no difference.
    [[nodiscard]] Step step() const noexcept {
        const Eigensystem<6> system(curvature_);
        const double least = 64.0 * eps * curvature_.diagonal().tail<3>().cwiseAbs().sum();
        Step step = Step::Zero();
        for (Index i = 0; i < 6; ++i) {
            const double size = std::fabs(system.values[i]);
            if (size > least) {
                step += system.vectors.col(i) * (system.vectors.col(i).dot(slope_) / size);
            }
        }
        constexpr double longest = 0.5;
        return step * std::min(1.0, longest / std::max(step.norm(), longest));
    }
    [[nodiscard]] BothSides after(const Products& products, const Step& step) const noexcept {
        return {products, rotation({1.0, step[0], step[1], step[2]}) * remainder_,
                rotation({2.0, step[3], step[4], step[5]}) * change_};
    }

private:
    /// The matrix of change q change' in the components of q.
    static Matrix4d conjugation_by(const Rotation& change) noexcept {
        Matrix4d matrix = Matrix4d::Identity();
        matrix.bottomRightCorner<3, 3>() = dcm::from_rotation(change);
        return matrix;
    }
    static Rotation best_remainder(const Products& products, const Rotation& change) noexcept {
        Eigen::Matrix<double, 16, 4> x;
        for (Index i = 0; i < 4; ++i) {
            x.col(i) = (product_by(Vector4d::Unit(i)) * conjugation_by(change)).reshaped();
        }
        const Eigen::Matrix<double, 16, 4> y = products.lazyProduct(x);
        return rotation(Eigensystem<4>(x.transpose().lazyProduct(y)).vectors.col(3));
    }

    Rotation remainder_;
    Rotation change_;
    double sum_ = 0.0;
    Step slope_;                            ///< halved
    Eigen::Matrix<double, 6, 6> curvature_; ///< halved, of the sum's negative
};

/// Those with the highest sum to which steps lead.
BothSides peak_from(const Products& products, BothSides sides) noexcept {
    constexpr int most_steps = 100;
    constexpr double near = 1e-7; // from here on each step squares what is left, down to the rounding
    double last = std::numeric_limits<double>::infinity();
    double part = 1.0;
    for (int i = 0; i < most_steps; ++i) {
        const Step step = part * sides.step();
        const double length = step.norm();
        if (length == 0.0 || (length < near && length >= 0.5 * last)) {
            break;
        }
        const BothSides next = sides.after(products, step);
        const bool higher = next.sum() > (1.0 - 16.0 * eps) * sides.sum();
        sides = higher ? next : sides;
        last = higher ? length : last;
        part = higher ? 1.0 : 0.25 * part;
    }
    return sides;
}

/// The change of axes that aligns the vectors sin(theta/2) cos(theta/2) n of the rotations from the first pair.
Rotation of_vectors(const Products& products) noexcept {
    const Matrix4d m = products.col(0).reshaped<Eigen::ColMajor>(4, 4); // of k q' times the product of their scalars
    const Davenport<double> k({m(1, 1), m(1, 2), m(1, 3), m(2, 1), m(2, 2), m(2, 3), m(3, 1), m(3, 2), m(3, 3)});
    Matrix4d matrix;
    matrix << k.ww, k.wx, k.wy, k.wz, k.wx, k.xx, k.xy, k.xz, k.wy, k.xy, k.yy, k.yz, k.wz, k.xz, k.yz, k.zz;
    return rotation(Eigensystem<4>(matrix).vectors.col(3));
}

} // namespace

void MeanRotation::add(const Rotation& rotation) noexcept {
    if (count_ == 0.0) {
        first_ = rotation;
    }
    const Rotation q = first_.inverse() * rotation;
    const double square = q.squared_norm();
    const Vector3d v(q.x(), q.y(), q.z());
    count_ += 1.0;
    products_ += v * (q.w() / square);
    squares_ += v * v.transpose() / square;
}

Matrix4d MeanRotation::squared_sines() const noexcept {
    Matrix4d matrix;
    matrix << squares_.trace(), -products_.transpose(), -products_, count_ * Matrix3d::Identity() - squares_;
    return matrix;
}

Rotation MeanRotation::mean() const noexcept {
    return first_ * rotation(Eigensystem<4>(squared_sines()).vectors.col(0));
}

double MeanRotation::rms() const noexcept {
    if (count_ == 0.0) {
        return 0.0;
    }
    return angle_of_squared_sine(std::clamp(Eigensystem<4>(squared_sines()).values[0] / count_, 0.0, 1.0));
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
    Entries g;
    for (Index i = 0; i < 4; ++i) {
        g.segment<4>(4 * i) = q[i] * k;
    }
    Eigen::Map<Eigen::Matrix<double, 16, 16>> products(products_.data());
    products += g * g.transpose();
}

std::optional<ConstantRotations> Alignment::rotations() const {
    const Found found = find();
    return found.determined ? std::optional(found.rotations) : std::nullopt;
}

Alignment::Found Alignment::find() const {
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
    return {side_ == AlignedSide::body ? ConstantRotations{.right = mean} : ConstantRotations{.left = mean},
            determined};
}

Alignment::Found Alignment::find_yaw() const noexcept {
    Eigen::Matrix<double, 4, 2> plane; // the identity and the half-turn about z, after the first rotation
    plane << unit(mean_.first_.inverse()), unit(mean_.first_.inverse() * Rotation::near_unit(0.0, 0.0, 0.0, 1.0));
    const Eigensystem<2> system(plane.transpose() * mean_.squared_sines() * plane);
    return {{Rotation::from_components(system.vectors(0, 0), 0.0, 0.0, system.vectors(1, 0)), {}},
            system.values[1] - system.values[0] > 64.0 * eps * mean_.count_};
}

Alignment::Found Alignment::find_both() const {
    const Products products(products_.data());
    const double count = mean_.count_;
    BothSides best = peak_from(products, {products, of_vectors(products)});
    constexpr double good = 0.99;
    constexpr std::size_t tried = 8;
    if (best.sum() < good * count) { // there may be a higher peak: some of the 24 rotations of the axes are near it
        std::vector<BothSides> starts;
        constexpr std::array components{0.0, 1.0, -1.0};
        for (std::size_t i = 1; i < 81; ++i) {
            const Vector4d q(components.at(i / 27), components.at(i / 9 % 3), components.at(i / 3 % 3),
                             components.at(i % 3));
            if (rotation(q).sign() > 0.0 && q.squaredNorm() != 3.0) {
                starts.emplace_back(products, rotation(q));
            }
        }
        std::ranges::sort(starts, std::greater(), &BothSides::sum);
        for (std::size_t i = 0; i < tried; ++i) {
            const BothSides other = peak_from(products, starts[i]);
            best = other.sum() > best.sum() ? other : best;
        }
    }
    // Errors alone give a curvature of about what is left over the root of the count.
    const double left = count - best.sum() + 64.0 * eps * count;
    return {{first_known_ * best.remainder() * best.change() * first_attitude_.inverse(), best.change().inverse()},
            best.least_curvature() * std::sqrt(count) > 4.0 * left};
}

} // namespace rotconv
