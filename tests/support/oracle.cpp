#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>

namespace oracle {
namespace {

using rotconv::AngleUnit;
using rotconv::RepresentationId;
using rotconv::Spec;

/// All definitions, in as many digits as Real has.
template <class Real> struct Definitions {
    using Matrix3 = Eigen::Matrix<Real, 3, 3>;
    using Matrix32 = Eigen::Matrix<Real, 3, 2>;
    using Vector3 = Eigen::Matrix<Real, 3, 1>;
    using Quaternion = Eigen::Quaternion<Real>;

    template <class Number> static std::vector<Real> own_order(const Spec& spec, std::span<const Number> written) {
        std::vector<Real> own(spec.size());
        for (std::size_t i = 0; i < own.size(); ++i) {
            // stated here anew, so that a slip in Spec::order() shows
            std::size_t place = i;
            if (spec.name == RepresentationId::quat && spec.scalar_last) {
                place = (i + 1) % 4;
            } else if (spec.name == RepresentationId::dcm && spec.column_major) {
                place = 3 * (i % 3) + i / 3;
            }
            own[place] = written[i];
        }
        return own;
    }

    static Matrix3 cross_matrix(const Vector3& v) {
        Matrix3 m;
        m << Real(0), -v.z(), v.y(), v.z(), Real(0), -v.x(), -v.y(), v.x(), Real(0);
        return m;
    }

    /// (I + [c])(I - [c])^-1, multiplied out so that a c of any length keeps its digits.
    static Matrix3 cayley_matrix(const Vector3& c) {
        const Real square = c.squaredNorm();
        const Matrix3 i = Matrix3::Identity();
        return ((1 - square) * i + 2 * (cross_matrix(c) + Matrix3(c * c.transpose()))) / (1 + square);
    }

    /// Newton's iteration M <- (M + M^-T)/2, where M (M'M)^-1 stands for M^-T of two columns.
    template <class Matrix> static Matrix polar_factor(Matrix m) {
        m /= m.norm();
        for (int step = 0; step < 200; ++step) {
            Matrix inverse_transpose;
            if constexpr (Matrix::ColsAtCompileTime == 3) {
                inverse_transpose = m.inverse().transpose();
            } else {
                inverse_transpose = m * (m.transpose() * m).inverse();
            }
            const Matrix next = Real(0.5) * (m + inverse_transpose);
            const Real change = (next - m).norm();
            m = next;
            if (change < 100 * std::numeric_limits<Real>::epsilon()) {
                break;
            }
        }
        return m;
    }

    /// Largest singular value of M - (polar factor of M), from E'E raised to a high power.
    template <class Matrix> static Real distance_to_polar_factor(const Matrix& m) {
        const Matrix e = m - polar_factor(m);
        const auto square = (e.transpose() * e).eval();
        auto power = square;
        for (int step = 0; step < 60 && power.norm() > 0; ++step) {
            power = (power * power).eval();
            power /= power.norm();
        }
        const Real trace = power.trace();
        return trace > 0 ? Real(sqrt((square * power).trace() / trace)) : Real(0);
    }

    static Matrix3 gram_schmidt(Vector3 first, Vector3 second) {
        first.normalize();
        second -= first.dot(second) * first;
        second.normalize();
        Matrix3 m;
        m << first, second, first.cross(second);
        return m;
    }

    static Matrix32 hopf_columns(const std::vector<Real>& y) {
        Real square = 0;
        for (const Real& component : y) {
            square += component * component;
        }
        const Real root2 = sqrt(Real(2));
        const Real factor = 2 * root2 / (square + 1);
        Matrix32 m;
        m << root2 * (square - 1) / (square + 1), factor * y[2], factor * y[0], factor * y[3], factor * y[1],
            factor * y[4];
        return m;
    }

    static Matrix3 turn(int axis, const Real& angle) {
        return Eigen::AngleAxis<Real>(angle, Vector3::Unit(axis)).toRotationMatrix();
    }

    /// Half-turn matrices have no real logarithm problem in a quaternion, which Eigen takes from the largest diagonal.
    static Quaternion unit(const Matrix3& m) {
        Quaternion q(m);
        q.normalize();
        return q;
    }

    static Quaternion about(const Vector3& axis, const Real& angle) {
        const Real largest = axis.cwiseAbs().maxCoeff();
        if (largest == 0) {
            return Quaternion::Identity();
        }
        const Vector3 n = (axis / largest).normalized();
        Quaternion q(Eigen::AngleAxis<Real>(angle, n));
        q.normalize();
        return q;
    }

    template <class Number> static Quaternion attitude(const Spec& spec, std::span<const Number> written) {
        const auto v = own_order(spec, written);
        // whole turns are taken off exactly, so that a half-turn of many turns is one
        const auto radians = [&](const Real& angle) {
            return spec.unit == AngleUnit::degrees ? Real(fmod(angle, Real(720)) * pi() / 180) : angle;
        };
        Quaternion q = Quaternion::Identity();
        switch (spec.name) {
        case RepresentationId::dcm: {
            Matrix3 m;
            m << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
            q = unit(polar_factor(m));
            break;
        }
        case RepresentationId::two_column: q = unit(gram_schmidt({v[0], v[1], v[2]}, {v[3], v[4], v[5]})); break;
        case RepresentationId::five_d: {
            const auto m = hopf_columns(v);
            q = unit(gram_schmidt(m.col(0), m.col(1)));
            break;
        }
        case RepresentationId::quat: {
            const Real largest = std::max({Real(abs(v[0])), Real(abs(v[1])), Real(abs(v[2])), Real(abs(v[3]))});
            q = Quaternion(v[0] / largest, v[1] / largest, v[2] / largest, v[3] / largest);
            q.normalize();
            break;
        }
        case RepresentationId::axis_angle: q = about({v[0], v[1], v[2]}, radians(v[3])); break;
        case RepresentationId::rotvec: {
            const Vector3 r(v[0], v[1], v[2]);
            q = about(r, radians(r.norm()));
            break;
        }
        case RepresentationId::euler:
        case RepresentationId::rpy: {
            Matrix3 m = Matrix3::Identity();
            for (std::size_t i = 0; i < 3; ++i) {
                const Matrix3 next = turn(spec.sequence.axis(i), spec.sequence.sign(i) * radians(v[i]));
                m = spec.sequence.intrinsic() ? Matrix3(m * next) : Matrix3(next * m);
            }
            q = unit(m);
            break;
        }
        case RepresentationId::cayley: q = unit(cayley_matrix({v[0], v[1], v[2]})); break;
        case RepresentationId::mrp: {
            const Matrix3 root = cayley_matrix({v[0], v[1], v[2]});
            q = unit(root * root);
            break;
        }
        default: throw std::logic_error("the oracle has no definition of this representation");
        }
        return spec.passive ? q.conjugate() : q;
    }

    /// What is nearer to 0 than this is rounding, of numbers near 1.
    static Real noise() { return 1e6 * std::numeric_limits<Real>::epsilon(); }

    static std::vector<Real> exact_numbers(const Spec& spec, const Quaternion& given) {
        const Quaternion q = spec.passive ? given.conjugate() : given;
        const Matrix3 r = q.toRotationMatrix();
        Vector3 v = q.vec();
        Real w = q.w();
        const bool half_turn = abs(w) < noise();
        const auto leader = std::find_if(v.begin(), v.end(), [](const Real& x) { return abs(x) >= noise(); });
        if (half_turn ? *leader < 0 : w < 0) {
            v = -v;
            w = -w;
        }
        const Real length = v.norm();
        const Real angle = 2 * atan2(length, w) * (spec.unit == AngleUnit::degrees ? Real(180 / pi()) : Real(1));
        std::vector<Real> own;
        switch (spec.name) {
        case RepresentationId::dcm:
            own = {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)};
            break;
        case RepresentationId::two_column: own = {r(0, 0), r(1, 0), r(2, 0), r(0, 1), r(1, 1), r(2, 1)}; break;
        case RepresentationId::five_d: {
            const Real d = sqrt(Real(2)) - r(0, 0);
            own = {r(1, 0) / d, r(2, 0) / d, r(0, 1) / d, r(1, 1) / d, r(2, 1) / d};
            break;
        }
        case RepresentationId::quat: own = {q.w(), q.x(), q.y(), q.z()}; break;
        case RepresentationId::axis_angle:
            own = length == 0 ? std::vector<Real>{1, 0, 0, 0}
                              : std::vector<Real>{v.x() / length, v.y() / length, v.z() / length, angle};
            break;
        case RepresentationId::rotvec:
            own = length == 0
                      ? std::vector<Real>{0, 0, 0}
                      : std::vector<Real>{v.x() / length * angle, v.y() / length * angle, v.z() / length * angle};
            break;
        case RepresentationId::cayley:
            for (const Real& x : v) {
                // a half-turn is infinite along its axis
                own.push_back(!half_turn         ? Real(x / w)
                              : abs(x) < noise() ? Real(0)
                                                 : Real(x < 0 ? -1 : 1) * std::numeric_limits<Real>::infinity());
            }
            break;
        case RepresentationId::mrp: own = {v.x() / (1 + w), v.y() / (1 + w), v.z() / (1 + w)}; break;
        case RepresentationId::euler:
        case RepresentationId::rpy: own = euler_angles(spec, r); break;
        default: throw std::logic_error("the oracle has no numbers of this representation");
        }
        const auto order = spec.order();
        std::vector<Real> written;
        for (std::size_t i = 0; i < own.size(); ++i) {
            written.push_back(own[order[i]]);
        }
        return written;
    }

    /// R = R_i(a) R_j(b) R_k(c) of own axes, or of fixed ones in reverse order. Within 1e-15 of lock the first angle in
    /// the order of the sequence takes all of the turn.
    static std::vector<Real> euler_angles(const Spec& spec, const Matrix3& r) {
        const auto sequence = spec.sequence;
        const bool own_axes = sequence.intrinsic();
        const int i = sequence.axis(own_axes ? 0 : 2);
        const int j = sequence.axis(1);
        const int k = 3 - i - j;
        const Real e = (j - i + 3) % 3 == 1 ? 1 : -1; // of the axes i, j, k in this order
        Real a;
        Real b;
        Real c;
        Real to_lock;
        Real sense; // of c, about the first axis, at the nearer lock
        if (sequence.proper()) {
            const Real sine = hypot_of(r(j, i), r(k, i));
            b = atan2(sine, r(i, i));
            const Real side = sequence.sign(1); // of the two triples the one with a middle angle of this sign
            a = atan2(Real(side * r(j, i)), Real(-side * e * r(k, i)));
            c = atan2(Real(side * r(i, j)), Real(side * e * r(i, k)));
            to_lock = r(i, i) > 0 ? b : Real(pi() - b);
            sense = r(i, i) > 0 ? 1 : -1;
            if (to_lock <= Real(1e-15)) {
                b = r(i, i) > 0 ? Real(0) : pi();
            }
        } else {
            const Real cosine = hypot_of(r(i, i), r(i, j));
            b = atan2(Real(e * r(i, k)), cosine);
            a = atan2(Real(-e * r(j, k)), r(k, k));
            c = atan2(Real(-e * r(i, j)), r(i, i));
            to_lock = atan2(cosine, Real(abs(r(i, k))));
            sense = r(i, k) > 0 ? 1 : -1; // R_j(b) turns k to e b i
            if (to_lock <= Real(1e-15)) {
                b = (b > 0 ? 1 : -1) * pi() / 2;
            }
        }
        std::vector<Real> angles = own_axes ? std::vector<Real>{a, b, c} : std::vector<Real>{c, b, a};
        if (to_lock <= Real(1e-15)) {
            // the sum, worked out where it is not lost: the turn that is left when R_j(b) is taken off
            const Matrix3 rest = own_axes ? Matrix3(r * turn(j, Real(-b))) : Matrix3(turn(j, Real(-b)) * r);
            const int axis = own_axes ? i : sequence.axis(0);
            const int next = (axis + 1) % 3;
            const int last = (axis + 2) % 3;
            angles[0] = to_lock < noise() ? Real(atan2(rest(last, next), rest(next, next)))
                                          : Real(angles[0] + sense * angles[2]);
            angles[0] -= 2 * pi() * round(Real(angles[0] / (2 * pi())));
            angles[2] = 0;
        }
        angles[1] *= sequence.proper() ? 1.0 : sequence.sign(1);
        for (const std::size_t outer : {0U, 2U}) {
            angles[outer] *= sequence.sign(outer);
            angles[outer] += angles[outer] <= -pi() ? Real(2 * pi()) : Real(0);
            if (spec.positive && angles[outer] < 0) { // what rounds to a full turn is 0
                angles[outer] = angles[outer] > -1e-20 ? Real(0) : Real(angles[outer] + 2 * pi());
            }
        }
        for (Real& angle : angles) {
            angle *= spec.unit == AngleUnit::degrees ? Real(180 / pi()) : Real(1);
        }
        return angles;
    }

    static Real hypot_of(const Real& x, const Real& y) { return sqrt(Real(x * x + y * y)); }

    static Real pi() { return boost::math::constants::pi<Real>(); }
};

using Own = Definitions<Real>;

bool is_outer_angle(const Spec& spec, std::size_t place) {
    return rotconv::representation(spec.name).has_gimbal_lock && place != 1;
}

/// The double of the number in the range that the contract gives.
template <class Real> double rounded(const Spec& spec, std::size_t place, const Real& number) {
    double value = static_cast<double>(number) + 0.0;
    const double half = spec.unit == AngleUnit::degrees ? 180.0 : 3.141592653589793;
    const bool outer = is_outer_angle(spec, place);
    return outer && value == -half ? half : outer && spec.positive && value == 2 * half ? 0.0 : value;
}

template <unsigned digits>
std::vector<Digits<digits>> exactly(const Spec& from, const Spec& to, std::span<const double> row) {
    using Exact = Definitions<Digits<digits>>;
    auto numbers = Exact::exact_numbers(to, Exact::attitude(from, row));
    if (to.name == RepresentationId::quat) { // its sign
        auto own = Exact::own_order(to, std::span<const Digits<digits>>(numbers));
        const auto leader =
            std::find_if(own.begin(), own.end(), [](const auto& x) { return abs(x) >= Exact::noise(); });
        if (*leader < 0) {
            for (auto& number : numbers) {
                number = -number;
            }
        }
    }
    return numbers;
}

/// Rounds the second numbers, and is certain where what distinguishes them from the first does not count.
template <class Rough, class Fine> bool round_all(const Spec& to, const std::vector<Rough>& rough,
                                                  const std::vector<Fine>& fine, std::vector<Rounded>& out) {
    out.assign(fine.size(), {});
    bool all = true;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        out[i].value = rounded(to, i, fine[i]);
        out[i].rest = static_cast<double>(Fine(fine[i] - Fine(out[i].value)));
        if (!isfinite(fine[i]) || fine[i] == 0) {
            out[i].certain = false; // more digits may tell the attitude from a half-turn, or the number from 0
        } else {
            Fine difference =
                abs(Fine(fine[i] - Fine(rough[i]))) + Fine(1e-300) * abs(fine[i]); // equal ones may be ties
            const Fine half_turn = to.unit == AngleUnit::degrees ? Fine(180) : boost::math::constants::pi<Fine>();
            if (is_outer_angle(to, i) && difference > half_turn) { // from the other side of the half-turn
                difference = abs(Fine(difference - 2 * half_turn));
            }
            const Fine doubt = 100 * difference;
            out[i].certain = rounded(to, i, Fine(fine[i] - doubt)) == out[i].value &&
                             rounded(to, i, Fine(fine[i] + doubt)) == out[i].value;
        }
        all = all && out[i].certain;
    }
    return all;
}

} // namespace

Real pi() { return Own::pi(); }

Quaternion about(const Vector3& axis, const Real& angle) { return Own::about(axis, angle); }

Quaternion attitude(const Spec& spec, std::span<const double> written) { return Own::attitude(spec, written); }

Quaternion attitude(const Spec& spec, std::span<const Real> written) { return Own::attitude(spec, written); }

Quaternion attitude(const rotconv::Rotation& r) { return Quaternion(r.w(), r.x(), r.y(), r.z()).normalized(); }

rotconv::Rotation rotation(const Quaternion& q) {
    return rotconv::Rotation::from_components(static_cast<double>(q.w()), static_cast<double>(q.x()),
                                              static_cast<double>(q.y()), static_cast<double>(q.z()));
}

std::vector<double> numbers(const Spec& spec, const Quaternion& given) {
    std::vector<double> rounded;
    for (const Real& number : exact_numbers(spec, given)) {
        rounded.push_back(static_cast<double>(number));
    }
    return rounded;
}

std::vector<Real> exact_numbers(const Spec& spec, const Quaternion& given) { return Own::exact_numbers(spec, given); }

std::vector<Rounded> converted(const Spec& from, const Spec& to, std::span<const double> row) {
    std::vector<Rounded> result;
    const auto first = exactly<36>(from, to, row);
    const auto second = exactly<72>(from, to, row);
    const auto components = Own::attitude(from, row).coeffs();
    const bool is_near_border = (components.array().abs() < Real(1e-20)).any(); // signs need more digits
    if (is_near_border || !round_all(to, first, second, result)) {
        const auto third = exactly<350>(from, to, row);
        if (!round_all(to, second, third, result)) {
            round_all(to, third, exactly<750>(from, to, row), result);
        }
    }
    // where one overflows, all do
    if (to.name == RepresentationId::cayley &&
        std::any_of(result.begin(), result.end(), [](const Rounded& r) { return std::isinf(r.value); })) {
        for (Rounded& r : result) {
            r.certain = r.certain || std::isinf(r.value);
            r.value = r.value == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), r.value);
        }
    }
    return result;
}

double error_in_eps(const Quaternion& p, const Quaternion& q) {
    const Quaternion difference = p.conjugate() * q;
    const Real sine = difference.vec().norm();
    return static_cast<double>(2 * atan2(sine, Real(abs(difference.w())))) / eps;
}

double relative_error_in_eps(const Quaternion& p, const Quaternion& q) {
    const Real angle = 2 * atan2(p.vec().norm(), Real(abs(p.w())));
    const Quaternion difference = p.conjugate() * q;
    const Real error = 2 * atan2(difference.vec().norm(), Real(abs(difference.w())));
    return static_cast<double>(error / angle) / eps;
}

Real defect(const Spec& spec, std::span<const double> written) {
    const auto v = Own::own_order(spec, written);
    switch (spec.name) {
    case RepresentationId::dcm: {
        Matrix3 m;
        m << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
        return Own::distance_to_polar_factor(m);
    }
    case RepresentationId::two_column: {
        Own::Matrix32 m;
        m << v[0], v[3], v[1], v[4], v[2], v[5];
        return Own::distance_to_polar_factor(m);
    }
    case RepresentationId::five_d: return Own::distance_to_polar_factor(Own::hopf_columns(v));
    case RepresentationId::quat: return abs(Eigen::Matrix<Real, 4, 1>(v[0], v[1], v[2], v[3]).norm() - 1);
    default: return 0;
    }
}

} // namespace oracle
