#include "methods.hpp"

#include <cmath>

namespace rotconv::formula::quat_to_rotvec {
namespace {

void along_vector_part(const double* q, double length, double angle, double* r) noexcept {
    const double scale = angle / length;
    r[0] = scale * q[1];
    r[1] = scale * q[2];
    r[2] = scale * q[3];
}

double vector_length(const double* q) noexcept { return std::sqrt((q[1] * q[1] + q[2] * q[2]) + q[3] * q[3]); }

} // namespace

/// Shuster 1993, from w = cos(theta/2): 2 acos(w) v/|v|.
void acos(const double* q, double* r) noexcept { along_vector_part(q, vector_length(q), 2.0 * std::acos(q[0]), r); }

/// The quaternion's logarithm, as in Sola 2017: 2 atan2(|v|, w) v/|v|.
void atan2(const double* q, double* r) noexcept {
    const double length = vector_length(q);
    along_vector_part(q, length, 2.0 * std::atan2(length, q[0]), r);
}

} // namespace rotconv::formula::quat_to_rotvec
