#pragma once

/// Everything of rotconv::core: the class Rotation, through which each conversion goes, a header for each
/// representation, and conversion of rows by SPEC.

#include <rotconv/alignment.hpp>
#include <rotconv/axes.hpp>
#include <rotconv/axis_angle.hpp>
#include <rotconv/cayley.hpp>
#include <rotconv/comparison.hpp>
#include <rotconv/continuous.hpp>
#include <rotconv/conversion.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/identification.hpp>
#include <rotconv/integration.hpp>
#include <rotconv/mrp.hpp>
#include <rotconv/product.hpp>
#include <rotconv/propagation.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/rotation_vector.hpp>
#include <rotconv/sampling.hpp>
#include <rotconv/survey.hpp>
#include <rotconv/two_column.hpp>
#include <rotconv/version.hpp>
