#pragma once

#include <cstddef>
#include <type_traits>

#include <Eigen/Core>

#include <rotconv/euler.hpp>

#include "../core/numerics/davenport.hpp"

// Published formulas, each for one row of numbers in the representations' own order: `m` row by row, active; `q` as
// w x y z; angles in radians. They add no guards of their own, so that a comparison shows what was published; those
// named `compensated` are nobody's: the same with products of twice the precision.

namespace rotconv::formula {

/// The function of a batch for a formula for one row, which takes the Euler sequence first where it needs it.
template <std::size_t In, std::size_t Out, auto one_row>
void each_row([[maybe_unused]] EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    for (std::size_t i = 0; i < rows; ++i, in += In, out += Out) {
        if constexpr (std::is_invocable_v<decltype(one_row), EulerSequence, const double*, double*>) {
            static_assert(noexcept(one_row(sequence, in, out)));
            one_row(sequence, in, out);
        } else {
            static_assert(noexcept(one_row(in, out)));
            one_row(in, out);
        }
    }
}

/// [v]_x, so that [v]_x u = v x u.
inline RowMajor cross_matrix(const double* v) noexcept {
    RowMajor cross;
    cross << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
    return cross;
}

namespace dcm_to_quat {
void trace(const double* m, double* q) noexcept;
void baruh(const double* m, double* q) noexcept;
void four_roots(const double* m, double* q) noexcept;
void klumpp(const double* m, double* q) noexcept;
void shepperd(const double* m, double* q) noexcept;
void markley(const double* m, double* q) noexcept;
void cayley(const double* m, double* q) noexcept;
void sarabandi_thomas(const double* m, double* q) noexcept;
void bar_itzhack(const double* m, double* q) noexcept;
void svd(const double* m, double* q) noexcept;
void polar(const double* m, double* q) noexcept;
void compensated(const double* m, double* q) noexcept;
} // namespace dcm_to_quat

namespace dcm_to_rotvec {
void acos(const double* m, double* r) noexcept;
void atan2(const double* m, double* r) noexcept;
void polynomial(const double* m, double* r) noexcept;
void quaternion(const double* m, double* r) noexcept;
void compensated(const double* m, double* r) noexcept;
} // namespace dcm_to_rotvec

namespace dcm_to_cayley {
void lu(const double* m, double* c) noexcept;
void polynomial(const double* m, double* c) noexcept;
void quaternion(const double* m, double* c) noexcept;
} // namespace dcm_to_cayley

namespace quat_to_dcm {
void unit(const double* q, double* m) noexcept;
void two_over_norm(const double* q, double* m) noexcept;
void homogeneous(const double* q, double* m) noexcept;
void normalise_first(const double* q, double* m) noexcept;
} // namespace quat_to_dcm

namespace quat_to_rotvec {
void acos(const double* q, double* r) noexcept;
void atan2(const double* q, double* r) noexcept;
void compensated(const double* q, double* r) noexcept;
} // namespace quat_to_rotvec

namespace quat_to_euler {
void classic(EulerSequence sequence, const double* q, double* angles) noexcept;
void matrix_threshold(EulerSequence sequence, const double* q, double* angles) noexcept;
void bernardes_arccos(EulerSequence sequence, const double* q, double* angles) noexcept;
void bernardes_atan2(EulerSequence sequence, const double* q, double* angles) noexcept;
} // namespace quat_to_euler

namespace rotvec_to_dcm {
void rodrigues(const double* r, double* m) noexcept;
void half_angle(const double* r, double* m) noexcept;
void quaternion(const double* r, double* m) noexcept;
void compensated(const double* r, double* m) noexcept;
} // namespace rotvec_to_dcm

namespace cayley_to_dcm {
void inverse(const double* c, double* m) noexcept;
void closed(const double* c, double* m) noexcept;
} // namespace cayley_to_dcm

} // namespace rotconv::formula
