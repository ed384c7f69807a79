#include <rotconv/dcm.hpp>
#include <rotconv/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>

#include "numerics/double_double.hpp"
#include "numerics/power_of_two.hpp"
#include "representations/rotation_angle.hpp"

namespace rotconv {

void throw_size(Eigen::Index rows, Eigen::Index columns, int needed_rows, int needed_columns) {
    const auto size = [](Eigen::Index r, Eigen::Index c) { return std::to_string(r) + "x" + std::to_string(c); };
    throw std::invalid_argument("rotconv: a matrix is " + size(rows, columns) + ", " +
                                size(needed_rows, needed_columns) + " is needed");
}

Rotation::Rotation(const Eigen::Matrix3d& matrix) : Rotation(*dcm::to_rotation(matrix)) {}

Rotation Rotation::scaled(double w, double x, double y, double z) {
    const std::array q{w, x, y, z};
    if (!all_finite(q.data(), 4) || q == std::array<double, 4>{}) {
        throw std::invalid_argument("rotconv: a quaternion of zeros, or with a component that is not finite");
    }
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(w, x, y, z));
    return {scale(w), scale(x), scale(y), scale(z)};
}

bool operator==(const Rotation& a, const Rotation& b) noexcept {
    const std::array<double, 4>& p = a.components();
    const std::array<double, 4>& q = b.components();
    const auto leader = static_cast<std::size_t>(
        std::ranges::max_element(p, {}, [](double component) { return std::fabs(component); }) - p.begin());
    for (std::size_t i = 0; i < 4; ++i) { // the quaternions are parallel
        const DoubleDouble first = two_prod(p.at(leader), q.at(i));
        const DoubleDouble second = two_prod(q.at(leader), p.at(i));
        if (first.hi != second.hi || first.lo != second.lo) {
            return false;
        }
    }
    return true;
}

std::ostream& operator<<(std::ostream& out, const Rotation& rotation) {
    const Eigen::Quaterniond q = quaternion::from_rotation(rotation);
    return out << q.w() + 0.0 << ' ' << q.x() + 0.0 << ' ' << q.y() + 0.0 << ' ' << q.z() + 0.0; // never -0
}

double Rotation::vector_length() const noexcept { return norm_of(q_[1], q_[2], q_[3]); }

double angle_between(const Rotation& a, const Rotation& b) noexcept { return angle_of(a * b.inverse()); }

std::optional<Rotation> interpolate(const Rotation& a, const Rotation& b, double fraction) {
    if (!(fraction >= 0.0 && fraction <= 1.0)) {
        throw std::invalid_argument("rotconv: a fraction is not in [0, 1]");
    }
    const Eigen::Vector4d p = unit(a);
    const Eigen::Vector4d q = unit(b);
    const double cosine = p.dot(q); // of the angle h between them, half that of the rotation
    if (std::abs(cosine) <= 4.0 * std::numeric_limits<double>::epsilon()) {
        return std::nullopt;
    }
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    if (p == sign * q) {
        return a;
    }
    const double h = 2.0 * angle_of((p + sign * q).norm(), (p - sign * q).norm(), AngleUnit::radians).hi;
    const double sine_of_h = sine_of(h);
    // If it underflows, the weights are linear.
    const double of_a = sine_of_h > 0.0 ? sine_of((1.0 - fraction) * h) / sine_of_h : 1.0 - fraction;
    const double of_b = sine_of_h > 0.0 ? sine_of(fraction * h) / sine_of_h : fraction;
    const Eigen::Vector4d r = of_a * p + (sign * of_b) * q;
    return rotation_at(r.data());
}

} // namespace rotconv
