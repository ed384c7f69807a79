#include "codec.hpp"
#include "matrix.hpp"
#include "rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Matrix {
    static constexpr std::size_t size = 9;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[9]) noexcept {
        scaled_matrix_of(q, numbers);
        divide_entries(numbers, squared_norm(q));
    }
};

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<Matrix>(rotations, rows, numbers);
}

/// k0 q0 + k1 q1 + k2 q2 + k3 q3 - mu q: what is small beside the products, with their own error of 2^-104.
ROTCONV_INLINE double residual(Real k0, double q0, Real k1, double q1, Real k2, double q2, Real k3, double q3,
                               double mu, double q) noexcept {
    const Real first = exact_product(k0.hi, q0);
    const Real second = exact_product(k1.hi, q1);
    const Real third = exact_product(k2.hi, q2);
    const Real fourth = exact_product(k3.hi, q3);
    const Real fifth = exact_product(-mu, q);
    const Real two = exact_sum(first.hi, fifth.hi); // the large ones cancel first
    const Real three = exact_sum(two.hi, second.hi);
    const Real four = exact_sum(third.hi, fourth.hi);
    const Real all = exact_sum(three.hi, four.hi);
    return all.hi + (((all.lo + two.lo) + (three.lo + four.lo)) +
                     (((first.lo + fifth.lo) + (second.lo + third.lo)) +
                      ((fourth.lo + k0.lo * q0) + ((k1.lo * q1 + k2.lo * q2) + k3.lo * q3))));
}
inline Wide residual(const Wide& k0, const Wide& q0, const Wide& k1, const Wide& q1, const Wide& k2, const Wide& q2,
                     const Wide& k3, const Wide& q3, double mu, const Wide& q) noexcept {
    return ((k0 * q0 - Wide(mu) * q) + k1 * q1) + (k2 * q2 + k3 * q3);
}

/// The inverse of a symmetric matrix.
struct Inverse {
    double xx, yy, zz, xy, xz, yz;

    ROTCONV_INLINE Inverse(double a_xx, double a_yy, double a_zz, double a_xy, double a_xz, double a_yz) noexcept
        : xx(a_yy * a_zz - a_yz * a_yz), yy(a_xx * a_zz - a_xz * a_xz), zz(a_xx * a_yy - a_xy * a_xy),
          xy(a_xz * a_yz - a_xy * a_zz), xz(a_xy * a_yz - a_xz * a_yy), yz(a_xy * a_xz - a_yz * a_xx) {
        const double factor = 1.0 / ((a_xx * xx + a_xy * xy) + a_xz * xz);
        xx *= factor;
        yy *= factor;
        zz *= factor;
        xy *= factor;
        xz *= factor;
        yz *= factor;
    }
};

/// One Newton step towards the unit quaternion that maximises trace(R(q)' M), where q is near it: the correction, in
/// parts that are small as q's own components are, so that small angles keep their relative accuracy. T is the
/// scalar of K, Small that of q, which is not normalised, and of what is small.
///
/// With S = R(q)' M the remaining small rotation d satisfies (tr(S) I - S) d = (S32 - S23, S13 - S31, S21 - S12), and
/// the right side is the vector part of q* (K - mu) q/|q|^2 for any mu. Near q's own eigenvalue nothing large is left.
template <class T, class Small> ROTCONV_INLINE void
newton_step(const double (&m)[9], const Small (&q)[4], const double (&near)[4], Small (&correction)[4]) noexcept {
    const Davenport<T> k(m);
    double r[9];
    const double ww = near[0] * near[0];
    const double xx = near[1] * near[1];
    const double yy = near[2] * near[2];
    const double zz = near[3] * near[3];
    r[0] = (ww - yy) + (xx - zz);
    r[1] = 2.0 * (near[1] * near[2] - near[0] * near[3]);
    r[2] = 2.0 * (near[1] * near[3] + near[0] * near[2]);
    r[3] = 2.0 * (near[1] * near[2] + near[0] * near[3]);
    r[4] = (ww - xx) + (yy - zz);
    r[5] = 2.0 * (near[2] * near[3] - near[0] * near[1]);
    r[6] = 2.0 * (near[1] * near[3] - near[0] * near[2]);
    r[7] = 2.0 * (near[2] * near[3] + near[0] * near[1]);
    r[8] = (ww - xx) + (zz - yy);
    const double norm = (ww + xx) + (yy + zz);
    const auto entry = [&](int i, int j) {
        return (r[i] * m[j] + r[3 + i] * m[3 + j]) + r[6 + i] * m[6 + j]; // of |q|^2 S
    };
    const double s_xx = entry(0, 0);
    const double s_yy = entry(1, 1);
    const double s_zz = entry(2, 2);
    const Inverse inverse(s_yy + s_zz, s_xx + s_zz, s_xx + s_yy, -0.5 * (entry(0, 1) + entry(1, 0)),
                          -0.5 * (entry(0, 2) + entry(2, 0)), -0.5 * (entry(1, 2) + entry(2, 1)));
    const double mu = 1.0 + (s_xx + s_yy + s_zz) / norm;

    const Small rest_w = residual(k.ww, q[0], k.wx, q[1], k.wy, q[2], k.wz, q[3], mu, q[0]);
    const Small rest_x = residual(k.wx, q[0], k.xx, q[1], k.xy, q[2], k.xz, q[3], mu, q[1]);
    const Small rest_y = residual(k.wy, q[0], k.yy, q[2], k.xy, q[1], k.yz, q[3], mu, q[2]);
    const Small rest_z = residual(k.wz, q[0], k.zz, q[3], k.xz, q[1], k.yz, q[2], mu, q[3]);

    // Half of d.
    const Small w = near[0];
    const Small x = near[1];
    const Small y = near[2];
    const Small z = near[3];
    const Small a = w * rest_x - x * rest_w - (y * rest_z - z * rest_y);
    const Small b = w * rest_y - y * rest_w - (z * rest_x - x * rest_z);
    const Small c = w * rest_z - z * rest_w - (x * rest_y - y * rest_x);
    const Small dx = 0.5 * ((inverse.xx * a + inverse.xy * b) + inverse.xz * c);
    const Small dy = 0.5 * ((inverse.xy * a + inverse.yy * b) + inverse.yz * c);
    const Small dz = 0.5 * ((inverse.xz * a + inverse.yz * b) + inverse.zz * c);

    // q (0, d/2). A component that K does not couple to the others stays 0, as at a symmetric matrix's half-turn.
    const auto stays = [&](double component, const T& first, const T& second, const T& third) {
        return component == 0.0 && nearly(first) == 0.0 && nearly(second) == 0.0 && nearly(third) == 0.0;
    };
    const Small none = 0.0;
    correction[0] = stays(near[0], k.wx, k.wy, k.wz) ? none : none - (x * dx + y * dy + z * dz);
    correction[1] = stays(near[1], k.wx, k.xy, k.xz) ? none : w * dx + (y * dz - z * dy);
    correction[2] = stays(near[2], k.wy, k.xy, k.yz) ? none : w * dy + (z * dx - x * dz);
    correction[3] = stays(near[3], k.wz, k.xz, k.yz) ? none : w * dz + (x * dy - y * dx);
}

/// Any proper matrix, from the plain answer on, until nothing is left to correct.
void refine(const double* numbers, Real (&q)[4]) noexcept {
    double largest = 0.0;
    for (std::size_t k = 0; k < 9; ++k) {
        largest = __builtin_fabs(numbers[k]) > largest ? __builtin_fabs(numbers[k]) : largest;
    }
    const int exponent = exponent_of(largest) < -1000 ? -1000 : exponent_of(largest);
    double m[9];
    for (std::size_t k = 0; k < 9; ++k) {
        m[k] = numbers[k] * power_of_two(-exponent / 2) * power_of_two(-exponent - -exponent / 2);
    }
    double last = 1.0;
    for (int step = 0; step < 100; ++step) {
        const Wide own[4] = {q[0], q[1], q[2], q[3]};
        const double near[4] = {q[0].hi, q[1].hi, q[2].hi, q[3].hi};
        Wide correction[4];
        newton_step<Wide>(m, own, near, correction);
        double size = 0.0;
        for (const Wide& part : correction) {
            size += __builtin_fabs(part.rounded());
        }
        if (!(size < 0.5 * last)) {
            return; // at the end of what can be told
        }
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = (own[k] + correction[k]).real();
        }
        if (size < 0x1p-75) {
            return;
        }
        last = size;
    }
}

void read(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<Real>& readings) noexcept {
    read_plain(spec, numbers, rows, readings);
    double columns[9][batch_rows];
    to_columns(numbers, rows, columns);
    BasicRotations<Real> exact;
    for (std::size_t i = 0; i < rows; ++i) {
        const double m[9] = {columns[0][i], columns[1][i], columns[2][i], columns[3][i], columns[4][i],
                             columns[5][i], columns[6][i], columns[7][i], columns[8][i]};
        const double q[4] = {readings.w.hi[i], readings.x.hi[i], readings.y.hi[i], readings.z.hi[i]};
        double correction[4];
        newton_step<Real>(m, q, q, correction);
        exact.set(i, exact_sum(q[0], correction[0]), exact_sum(q[1], correction[1]), exact_sum(q[2], correction[2]),
                  exact_sum(q[3], correction[3]));
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (readings.error[i] != Error::none) {
            continue;
        }
        // A plain answer is right to rounding where the defect is small; that of another matrix may be off by more.
        bool one_step = readings.defect[i] <= 0.04;
        for (const auto& column : columns) {
            one_step = one_step && is_ordinary(column[i]);
        }
        if (one_step) [[likely]] {
            readings.set(i, exact.w[i], exact.x[i], exact.y[i], exact.z[i]);
        } else {
            Real q[4];
            readings.get(i, q);
            refine(numbers + 9 * i, q);
            readings.set(i, q);
        }
    }
}

} // namespace

constinit const BatchCodec batch_codecs::dcm{.fast = {.read = nullptr, .write = write<double>},
                                             .exact = {.read = read, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
