#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <rotconv/rotation.hpp>
#include <rotconv/spec.hpp>

/// The attitudes that numbers stand for, in 36 digits or more, from the definitions and not from rotconv's formulas:
/// matrices are multiplied, inverted and exponentiated; the polar factor comes from Newton's iteration.
namespace oracle {

template <unsigned digits> using Digits = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

using Real = Digits<36>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Quaternion = Eigen::Quaternion<Real>;

/// A number that counts attitude errors: 2^-52 radians.
inline constexpr double eps = 0x1p-52;

Real pi();

/// The exact attitude of doubles written as the spec says, as a unit quaternion of either sign.
Quaternion attitude(const rotconv::Spec& spec, std::span<const double> numbers);
Quaternion attitude(const rotconv::Spec& spec, std::span<const Real> numbers);

/// Between the library's rotations and the oracle's.
Quaternion attitude(const rotconv::Rotation& rotation);
rotconv::Rotation rotation(const Quaternion& attitude);

/// The numbers of an attitude, rounded once to double: input for tests. Not for euler and rpy, where the angles are
/// chosen.
std::vector<double> numbers(const rotconv::Spec& spec, const Quaternion& attitude);
/// The same before rounding, for all representations; with a lock margin of 1e-15.
std::vector<Real> exact_numbers(const rotconv::Spec& spec, const Quaternion& attitude);

/// A number rounded once.
struct Rounded {
    double value = 0.0;
    double rest = 0.0;   ///< what the exact number has more
    bool certain = true; ///< false where it is a tie, as far as 700 digits tell
};

/// What a conversion of the row is to print: worked out in more and more digits until the rounding of each number is
/// certain.
std::vector<Rounded> converted(const rotconv::Spec& from, const rotconv::Spec& to, std::span<const double> numbers);

/// The unit quaternion of an axis (any length) and an angle.
Quaternion about(const Vector3& axis, const Real& angle);

/// Rotation angle from p to q, in units of eps.
double error_in_eps(const Quaternion& p, const Quaternion& q);

/// Rotation angle from p to q, in units of eps times the angle of p.
double relative_error_in_eps(const Quaternion& p, const Quaternion& q);

/// Largest |s - 1| over the singular values s of the matrix or the two columns; | |q| - 1 | of a quaternion; 0 for
/// others.
Real defect(const rotconv::Spec& spec, std::span<const double> numbers);

} // namespace oracle
