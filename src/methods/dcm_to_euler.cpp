#include "formulas.hpp"

#include <limits>
#include <numbers>

namespace rotconv::formula::dcm_to_euler {
namespace {

constexpr double pi = std::numbers::pi;

double wrapped(double angle) noexcept {
    return angle <= -pi ? angle + 2.0 * pi : angle > pi ? angle - 2.0 * pi : angle;
}

/// The entries of a rotation matrix by the axes of the sequence, read as rotations about moving axes, i first: R =
/// R_i(first) R_j(middle) R_k(third), or with R_i at the end. Fixed axes are the same rotations in reverse order. For a
/// proper sequence k is the axis that does not occur.
struct MovingAxes {
    MovingAxes(EulerSequence sequence, const double* matrix) noexcept
        : i(sequence.axis(sequence.intrinsic() ? 0 : 2)), j(sequence.axis(1)), k(3 - i - j),
          sign((j - i + 3) % 3 == 1 ? 1.0 : -1.0), proper(sequence.proper()), m(matrix) {}

    /// The middle angle with the outer angles, by atan2 of entries divided by `divisor`.
    [[nodiscard]] MovingAngles angles(double middle, double divisor = 1.0) const noexcept {
        const auto angle = [divisor](double y, double x) { return std::atan2(y / divisor, x / divisor); };
        if (proper) {
            return {angle(m(j, i), -sign * m(k, i)), middle, angle(m(i, j), sign * m(i, k))};
        }
        return {angle(-sign * m(j, k), m(k, k)), middle, angle(-sign * m(i, j), m(i, i))};
    }

    /// The cosine of the middle angle for a proper sequence, its sine for another.
    [[nodiscard]] double middle_entry() const noexcept { return proper ? m(i, i) : sign * m(i, k); }

    [[nodiscard]] double middle_angle() const noexcept {
        return proper ? std::acos(middle_entry()) : std::asin(middle_entry());
    }

    /// The middle angle by the length of the other entries.
    [[nodiscard]] double middle_with(double length) const noexcept {
        return proper ? std::atan2(length, middle_entry()) : std::atan2(middle_entry(), length);
    }

    /// The third angle after the rotation by the first is undone, from row j of R_i(-first) R.
    [[nodiscard]] double third_after(double first) const noexcept {
        const double cos = std::cos(first);
        const double sin = sign * std::sin(first);
        const int other = proper ? k : i;
        return std::atan2((proper ? -sign : sign) * (cos * m(j, other) + sin * m(k, other)),
                          cos * m(j, j) + sin * m(k, j));
    }

    int i, j, k;
    double sign;
    bool proper;
    Eigen::Map<const RowMajor> m;
};

} // namespace

void set(EulerSequence sequence, const MovingAngles& moving, double* angles) noexcept {
    angles[0] = wrapped(sequence.intrinsic() ? moving.first : moving.third);
    angles[1] = wrapped(moving.middle);
    angles[2] = wrapped(sequence.intrinsic() ? moving.third : moving.first);
}

/// Textbook form, in Diebel 2006 for the twelve sequences: atan2 for the outer angles, asin or acos of one entry for
/// the middle one.
void asin(EulerSequence sequence, const double* m, double* angles) noexcept {
    const MovingAxes r(sequence, m);
    set(sequence, r.angles(r.middle_angle()), angles);
}

/// Slabaugh's note of 1999, which is for ZYX; the other sequences in the same way. Entries over the cosine (for a
/// proper sequence the sine) of the middle angle, by atan2; at lock, which is an entry of exactly +-1, the first angle
/// is 0.
void slabaugh(EulerSequence sequence, const double* m, double* angles) noexcept {
    const MovingAxes r(sequence, m);
    const double entry = r.middle_entry();
    const double middle = r.middle_angle();
    MovingAngles moving = r.angles(middle, r.proper ? std::sin(middle) : std::cos(middle));
    if (std::fabs(entry) == 1.0) {
        moving.first = 0.0;
        moving.third = std::atan2((r.proper ? r.sign : 1.0) * entry * r.m(r.k, r.j),
                                  entry * (r.proper ? r.m(r.k, r.k) : -r.sign * r.m(r.k, r.i)));
    }
    set(sequence, moving, angles);
}

/// Shoemake 1994, Graphics Gems IV, Eul_FromHMatrix: the middle angle by atan2 with the hypotenuse of two entries;
/// where this is small an outer angle is 0, here the third of the sequence.
void shoemake(EulerSequence sequence, const double* m, double* angles) noexcept {
    constexpr double lock = 16.0 * std::numeric_limits<float>::epsilon(); // 1.9e-6, as in his program
    const MovingAxes r(sequence, m);
    const double beside = r.m(r.i, r.proper ? r.k : r.i);
    const double hypotenuse = std::sqrt(beside * beside + r.m(r.i, r.j) * r.m(r.i, r.j));
    MovingAngles moving{0.0, r.middle_with(hypotenuse), 0.0};
    if (hypotenuse > lock) {
        moving = r.angles(moving.middle);
    } else if (sequence.intrinsic()) { // R = R_i R_j
        moving.first = std::atan2(r.sign * r.m(r.k, r.j), r.m(r.j, r.j));
    } else { // the third of the sequence is the first of the moving axes
        moving.third = r.third_after(0.0);
    }
    set(sequence, moving, angles);
}

/// Shuster and Markley 2006, Eqs 5-12, as SciPy once had it, for rotations about moving axes: in a frame of the axes of
/// the sequence all are ZXZ, whose middle angle is an arccos, clipped as there, moved by lambda. Within 1e-7 of gimbal
/// lock the third angle is 0, and the first their sum or difference.
void shuster_markley(EulerSequence sequence, const double* m, double* angles) noexcept {
    constexpr double lock = 1e-7;
    const MovingAxes r(sequence, m);
    Eigen::Matrix3d frame;
    frame << Eigen::Vector3d::Unit(r.j), r.sign * Eigen::Vector3d::Unit(r.k), Eigen::Vector3d::Unit(r.i);
    Eigen::Matrix3d o = frame.transpose() * r.m * frame;
    if (!r.proper) { // turned back by lambda about the first axis
        const Eigen::Vector3d second = o.col(1);
        o.col(1) = -r.sign * o.col(2);
        o.col(2) = r.sign * second;
    }
    const double lambda = r.proper ? 0.0 : r.sign * 0.5 * pi;
    const double middle = std::acos(std::clamp(o(2, 2), -1.0, 1.0));
    MovingAngles moving{0.0, lambda + middle, 0.0};
    if (middle < lock) {
        moving.first = std::atan2(o(1, 0) - o(0, 1), o(0, 0) + o(1, 1));
    } else if (pi - middle < lock) {
        moving.first = std::atan2(o(1, 0) + o(0, 1), o(0, 0) - o(1, 1));
    } else {
        moving.first = std::atan2(o(0, 2), -o(1, 2));
        moving.third = std::atan2(o(2, 0), o(2, 1));
        if (lambda > 0.0) { // the triple with the middle angle in its range
            moving = {moving.first + pi, 2.0 * lambda - moving.middle, moving.third - pi};
        }
    }
    set(sequence, moving, angles);
}

/// Eigen 3.4, MatrixBase::eulerAngles, in our words: the triple whose first angle is in [0, pi], the middle one in
/// (-pi, pi]; the third from the matrix with the first rotation undone.
void eigen(EulerSequence sequence, const double* m, double* angles) noexcept {
    const MovingAxes r(sequence, m);
    const double beside = r.proper ? r.m(r.k, r.i) : r.m(r.i, r.i);
    const double before = r.proper ? r.m(r.j, r.i) : r.m(r.i, r.j);
    const double length = std::sqrt(before * before + beside * beside);
    MovingAngles moving = r.angles(r.middle_with(length));
    if (moving.first < 0.0) {
        moving.first += pi;
        moving.middle = r.middle_with(-length);
    }
    moving.third = r.third_after(moving.first);
    set(sequence, moving, angles);
}

} // namespace rotconv::formula::dcm_to_euler
