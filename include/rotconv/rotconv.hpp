#pragma once

/// Everything of rotconv::core: the class Rotation, through which each conversion goes, a header for each
/// representation, and conversion of rows by SPEC.
///
/// | SPEC            | header              | namespace       | type                |
/// | --------------- | ------------------- | --------------- | ------------------- |
/// | dcm             | dcm.hpp             | dcm             | Dcm                 |
/// | 6d              | two_column.hpp      | two_column      | TwoColumns          |
/// | 5d              | two_column.hpp      | five_d          | five_d::Vector5     |
/// | quat            | quaternion.hpp      | quaternion      | Eigen::Quaterniond  |
/// | axis-angle      | axis_angle.hpp      | axis_angle      | AxisAngle           |
/// | rotvec          | rotation_vector.hpp | rotation_vector | RotationVector      |
/// | euler:SEQ, rpy  | euler.hpp           | euler           | EulerAngles         |
/// | cayley          | cayley.hpp          | cayley          | Eigen::Vector3d     |
/// | mrp             | mrp.hpp             | mrp             | Eigen::Vector3d     |
///
/// Rows of numbers: parse_spec() of spec.hpp, Conversion of conversion.hpp, and numbers_of() there for a matrix of
/// Eigen. Two attitudes: angle_between() and interpolate() of rotation.hpp. Errors in words: message().

#include <rotconv/alignment.hpp>
#include <rotconv/axes.hpp>
#include <rotconv/axis_angle.hpp>
#include <rotconv/cayley.hpp>
#include <rotconv/comparison.hpp>
#include <rotconv/continuous.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/integration.hpp>
#include <rotconv/mrp.hpp>
#include <rotconv/product.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/rotation_vector.hpp>
#include <rotconv/sampling.hpp>
#include <rotconv/two_column.hpp>
#include <rotconv/version.hpp>
