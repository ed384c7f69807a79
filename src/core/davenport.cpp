#include "davenport.hpp"

namespace rotconv {
namespace {

/// K q.
Eigen::Vector4d product(const Eigen::Matrix4d& k, const Eigen::Vector4d& q) noexcept {
    return (k.col(0) * q[0] + k.col(1) * q[1]) + (k.col(2) * q[2] + k.col(3) * q[3]);
}

/// Numbers up to 4, cut to multiples of 2^-24: their products and the sums of four of these are exact.
template <class Numbers> Numbers cut(const Numbers& numbers) noexcept {
    constexpr double shift = 1.5 * 0x1p28;
    return ((numbers.array() + shift) - shift).matrix();
}

} // namespace

Eigen::Matrix4d davenport_matrix(const Eigen::Matrix3d& m) noexcept {
    const double plus = 1.0 + m(0, 0);
    const double minus = 1.0 - m(0, 0);
    const double sum = m(1, 1) + m(2, 2);
    const double difference = m(1, 1) - m(2, 2);
    const double wx = m(2, 1) - m(1, 2);
    const double wy = m(0, 2) - m(2, 0);
    const double wz = m(1, 0) - m(0, 1);
    const double xy = m(0, 1) + m(1, 0);
    const double xz = m(0, 2) + m(2, 0);
    const double yz = m(1, 2) + m(2, 1);
    Eigen::Matrix4d k;
    k << plus + sum, wx, wy, wz,        //
        wx, plus - sum, xy, xz,         //
        wy, xy, minus + difference, yz, //
        wz, xz, yz, minus - difference;
    return k;
}

Eigen::Vector4d pivot_column(const Eigen::Matrix4d& k) noexcept {
    Eigen::Index pivot = 0;
    for (Eigen::Index i = 1; i < 4; ++i) {
        if (k(i, i) > k(pivot, pivot)) {
            pivot = i;
        }
    }
    return 0.25 * k.col(pivot);
}

Eigen::Vector4d power_step(const Eigen::Matrix4d& k, const Eigen::Vector4d& q) noexcept { return 0.25 * product(k, q); }

Eigen::Vector4d exact_power_step(const Eigen::Matrix4d& k, const Eigen::Vector4d& q) noexcept {
    const Eigen::Matrix4d k_high = cut(k);
    const Eigen::Matrix4d k_low = k - k_high;
    const Eigen::Vector4d q_high = cut(q);
    const Eigen::Vector4d q_low = q - q_high;
    return 0.25 * (product(k_high, q_high) + (product(k_low, q_high) + product(k, q_low)));
}

Eigen::Vector4d quaternion_of_rotation(const Eigen::Matrix3d& m) noexcept {
    const Eigen::Matrix4d k = davenport_matrix(m);
    return exact_power_step(k, pivot_column(k));
}

} // namespace rotconv
