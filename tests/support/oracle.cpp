#include "oracle.hpp"

#include <stdexcept>

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>

namespace oracle {
namespace {

using rotconv::AngleUnit;
using rotconv::RepresentationId;
using rotconv::Spec;
using Matrix32 = Eigen::Matrix<Real, 3, 2>;

template <class Number> std::vector<Real> own_order(const Spec& spec, std::span<const Number> written) {
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

Matrix3 cross_matrix(const Vector3& v) {
    Matrix3 m;
    m << Real(0), -v.z(), v.y(), v.z(), Real(0), -v.x(), -v.y(), v.x(), Real(0);
    return m;
}

/// (I + [c])(I - [c])^-1, multiplied out so that a c of any length keeps its digits.
Matrix3 cayley_matrix(const Vector3& c) {
    const Real square = c.squaredNorm();
    const Matrix3 i = Matrix3::Identity();
    return ((1 - square) * i + 2 * (cross_matrix(c) + Matrix3(c * c.transpose()))) / (1 + square);
}

/// Newton's iteration M <- (M + M^-T)/2, where M (M'M)^-1 stands for M^-T of two columns.
template <class Matrix> Matrix polar_factor(Matrix m) {
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
        if (change < Real(1e-34)) {
            break;
        }
    }
    return m;
}

/// Largest singular value of M - (polar factor of M), from E'E raised to a high power.
template <class Matrix> Real distance_to_polar_factor(const Matrix& m) {
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

Matrix3 gram_schmidt(Vector3 first, Vector3 second) {
    first.normalize();
    second -= first.dot(second) * first;
    second.normalize();
    Matrix3 m;
    m << first, second, first.cross(second);
    return m;
}

Matrix32 hopf_columns(const std::vector<Real>& y) {
    Real square = 0;
    for (const Real& component : y) {
        square += component * component;
    }
    const Real root2 = sqrt(Real(2));
    const Real factor = 2 * root2 / (square + 1);
    Matrix32 m;
    m << root2 * (square - 1) / (square + 1), factor * y[2], factor * y[0], factor * y[3], factor * y[1], factor * y[4];
    return m;
}

Matrix3 turn(int axis, const Real& angle) {
    return Eigen::AngleAxis<Real>(angle, Vector3::Unit(axis)).toRotationMatrix();
}

/// Half-turn matrices have no real logarithm problem in a quaternion, which Eigen takes from the largest diagonal.
Quaternion unit(const Matrix3& m) {
    Quaternion q(m);
    q.normalize();
    return q;
}

} // namespace

Real pi() { return boost::math::constants::pi<Real>(); }

Quaternion about(const Vector3& axis, const Real& angle) {
    const Real largest = axis.cwiseAbs().maxCoeff();
    if (largest == 0) {
        return Quaternion::Identity();
    }
    const Vector3 n = (axis / largest).normalized();
    Quaternion q(Eigen::AngleAxis<Real>(angle, n));
    q.normalize();
    return q;
}

Quaternion attitude(const Spec& spec, std::span<const double> written) {
    const std::vector<Real> exact(written.begin(), written.end());
    return attitude(spec, std::span<const Real>(exact));
}

Quaternion attitude(const Spec& spec, std::span<const Real> written) {
    const auto v = own_order(spec, written);
    const Real per_unit = spec.unit == AngleUnit::degrees ? Real(pi() / 180) : Real(1);
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
    case RepresentationId::axis_angle: q = about({v[0], v[1], v[2]}, v[3] * per_unit); break;
    case RepresentationId::rotvec: {
        const Vector3 r(v[0], v[1], v[2]);
        q = about(r, r.norm() * per_unit);
        break;
    }
    case RepresentationId::euler:
    case RepresentationId::rpy: {
        Matrix3 m = Matrix3::Identity();
        for (std::size_t i = 0; i < 3; ++i) {
            const Matrix3 next = turn(spec.sequence.axis(i), v[i] * per_unit);
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

std::vector<double> numbers(const Spec& spec, const Quaternion& given) {
    std::vector<double> rounded;
    for (const Real& number : exact_numbers(spec, given)) {
        rounded.push_back(static_cast<double>(number));
    }
    return rounded;
}

std::vector<Real> exact_numbers(const Spec& spec, const Quaternion& given) {
    const Quaternion q = spec.passive ? given.conjugate() : given;
    const Matrix3 r = q.toRotationMatrix();
    const Real sign = q.w() < 0 ? -1 : 1;
    const Vector3 v = sign * q.vec();
    const Real w = sign * q.w();
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
    case RepresentationId::axis_angle: own = {v.x() / length, v.y() / length, v.z() / length, angle}; break;
    case RepresentationId::rotvec:
        own = {v.x() / length * angle, v.y() / length * angle, v.z() / length * angle};
        break;
    case RepresentationId::cayley: own = {v.x() / w, v.y() / w, v.z() / w}; break;
    case RepresentationId::mrp: own = {v.x() / (1 + w), v.y() / (1 + w), v.z() / (1 + w)}; break;
    default: throw std::logic_error("the oracle has no numbers of this representation");
    }
    const auto order = spec.order();
    std::vector<Real> written;
    for (std::size_t i = 0; i < own.size(); ++i) {
        written.push_back(own[order[i]]);
    }
    return written;
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
    const auto v = own_order(spec, written);
    switch (spec.name) {
    case RepresentationId::dcm: {
        Matrix3 m;
        m << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
        return distance_to_polar_factor(m);
    }
    case RepresentationId::two_column: {
        Matrix32 m;
        m << v[0], v[3], v[1], v[4], v[2], v[5];
        return distance_to_polar_factor(m);
    }
    case RepresentationId::five_d: return distance_to_polar_factor(hopf_columns(v));
    case RepresentationId::quat: return abs(Eigen::Matrix<Real, 4, 1>(v[0], v[1], v[2], v[3]).norm() - 1);
    default: return 0;
    }
}

} // namespace oracle
