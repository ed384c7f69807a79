#include "kernel.hpp"
#include "matrices.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// Whether the defect, below 3 d, is too large for power steps alone to be the quickest: each gains a factor of at
/// least 20.
ROTCONV_INLINE bool is_far(double square) noexcept { return !(9.0 * square <= 0.05 * 0.05); }

/// k0 q0 + k1 q1 + k2 q2 + k3 q3 - mu q: what is small beside the products, with their own error of 2^-104.
ROTCONV_INLINE double residual(DoubleDouble k0, double q0, DoubleDouble k1, double q1, DoubleDouble k2, double q2,
                               DoubleDouble k3, double q3, double mu, double q) noexcept {
    const DoubleDouble first = two_prod(k0.hi, q0);
    const DoubleDouble second = two_prod(k1.hi, q1);
    const DoubleDouble third = two_prod(k2.hi, q2);
    const DoubleDouble fourth = two_prod(k3.hi, q3);
    const DoubleDouble fifth = two_prod(-mu, q);
    const DoubleDouble two = two_sum(first.hi, fifth.hi); // the large ones cancel first
    const DoubleDouble three = two_sum(two.hi, second.hi);
    const DoubleDouble four = two_sum(third.hi, fourth.hi);
    const DoubleDouble all = two_sum(three.hi, four.hi);
    return all.hi + (((all.lo + two.lo) + (three.lo + four.lo)) +
                     (((first.lo + fifth.lo) + (second.lo + third.lo)) +
                      ((fourth.lo + k0.lo * q0) + ((k1.lo * q1 + k2.lo * q2) + k3.lo * q3))));
}
template <class T, class Base> T residual(const T& k0, const T& q0, const T& k1, const T& q1, const T& k2, const T& q2,
                                          const T& k3, const T& q3, const Base& mu, const T& q) noexcept {
    return ((k0 * q0 - T(mu) * q) + k1 * q1) + (k2 * q2 + k3 * q3);
}

/// The inverse of a symmetric matrix.
template <class T> struct Inverse {
    Inverse() = default;
    ROTCONV_INLINE Inverse(const T& a_xx, const T& a_yy, const T& a_zz, const T& a_xy, const T& a_xz,
                           const T& a_yz) noexcept
        : xx(a_yy * a_zz - a_yz * a_yz), yy(a_xx * a_zz - a_xz * a_xz), zz(a_xx * a_yy - a_xy * a_xy),
          xy(a_xz * a_yz - a_xy * a_zz), xz(a_xy * a_yz - a_xz * a_yy), yz(a_xy * a_xz - a_yz * a_xx) {
        const T factor = T(1.0) / ((a_xx * xx + a_xy * xy) + a_xz * xz);
        for (T* const entry : {&xx, &yy, &zz, &xy, &xz, &yz}) {
            *entry = *entry * factor;
        }
    }

    T xx, yy, zz, xy, xz, yz;
};

/// What of a Newton step only has to be near: at `near` for q. An error e of it leaves e^2, as the step itself does.
template <class Base> struct StepBase {
    ROTCONV_INLINE StepBase(const Base (&m)[9], const Base (&q)[4]) noexcept : near{q[0], q[1], q[2], q[3]} {
        Base r[9];
        scaled_matrix_of(near, r);
        const Base norm = squared_norm(near);
        const auto entry = [&](int i, int j) {
            return (r[i] * m[j] + r[3 + i] * m[3 + j]) + r[6 + i] * m[6 + j]; // of |q|^2 S
        };
        const Base s_xx = entry(0, 0);
        const Base s_yy = entry(1, 1);
        const Base s_zz = entry(2, 2);
        inverse = Inverse<Base>(s_yy + s_zz, s_xx + s_zz, s_xx + s_yy, scaled(entry(0, 1) + entry(1, 0), -0.5),
                                scaled(entry(0, 2) + entry(2, 0), -0.5), scaled(entry(1, 2) + entry(2, 1), -0.5));
        mu = Base(1.0) + (s_xx + s_yy + s_zz) / norm;
    }

    Base near[4];
    Inverse<Base> inverse;
    Base mu;
};

/// One Newton step towards the unit quaternion that maximises trace(R(q)' M), where q is near it: the correction, in
/// parts that are small as q's own components are, so that small angles keep their relative accuracy. T is the
/// scalar of K, Small that of q, which is not normalised, and of what is small, Base that of M and of the step's base.
///
/// With S = R(q)' M the remaining small rotation d satisfies (tr(S) I - S) d = (S32 - S23, S13 - S31, S21 - S12), and
/// the right side is the vector part of q* (K - mu) q/|q|^2 for any mu. Near q's own eigenvalue nothing large is left.
template <class T, class Small, class Base> ROTCONV_INLINE void
newton_step(const Base (&m)[9], const Small (&q)[4], const StepBase<Base>& base, Small (&correction)[4]) noexcept {
    const Davenport<T> k(m);
    const auto& near = base.near; // clang's lambdas take no structured bindings
    const auto& inverse = base.inverse;
    const auto& mu = base.mu;
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
    const Small dx = scaled((inverse.xx * a + inverse.xy * b) + inverse.xz * c, 0.5);
    const Small dy = scaled((inverse.xy * a + inverse.yy * b) + inverse.yz * c, 0.5);
    const Small dz = scaled((inverse.xz * a + inverse.yz * b) + inverse.zz * c, 0.5);
    // q (0, d/2). A component that K does not couple to the others stays 0, as at a symmetric matrix's half-turn.
    const auto stays = [&](unsigned i) { return sign_of(near[i]) == 0.0 && k.stands_alone(i); };
    const Small none = 0.0;
    correction[0] = stays(0) ? none : none - (x * dx + y * dy + z * dz);
    correction[1] = stays(1) ? none : w * dx + (y * dz - z * dy);
    correction[2] = stays(2) ? none : w * dy + (z * dx - x * dz);
    correction[3] = stays(3) ? none : w * dz + (x * dy - y * dx);
}

/// Any proper matrix of ordinary size, to 106 bits: from a quaternion near its own on, until nothing is left to
/// correct.
void refine(const double* numbers, const double (&start)[4], DoubleDouble (&q)[4]) noexcept {
    load(start, q);
    double m[9];
    load(numbers, m);
    const PowerOfTwo to_unit = PowerOfTwo::to_unit(
        larger_of(largest_magnitude(m[0], m[1], m[2], m[3], m[4]), largest_magnitude(m[5], m[6], m[7], m[8])));
    for (double& entry : m) {
        entry = to_unit(entry);
    }
    double last = 1.0;
    for (int step = 0; step < 100; ++step) {
        const double near[4] = {q[0].hi, q[1].hi, q[2].hi, q[3].hi};
        DoubleDouble correction[4];
        newton_step<DoubleDouble>(m, q, StepBase(m, near), correction);
        const double size = largest_magnitude(correction[0].hi, correction[1].hi, correction[2].hi, correction[3].hi);
        if (!(size < 0.5 * last)) {
            return; // at the end of what can be told
        }
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = q[k] + correction[k];
        }
        last = size;
    }
}

/// Any proper matrix. Each step squares the error, so that a correction of half of the bits is the last one, where the
/// matrix is near a rotation; elsewhere one of which nothing is left beside the bits, which is more than what is left.
void refine(const double* numbers, const double (&start)[4], bool is_near, Careful (&q)[4]) noexcept {
    load(start, q);
    Careful m[9];
    load(numbers, m);
    int exponent = m[0].exponent();
    for (const Careful& entry : m) {
        exponent = entry.exponent() > exponent ? entry.exponent() : exponent;
    }
    for (Careful& entry : m) {
        entry = entry.shifted(-exponent);
    }
    const int bits = Wide::Bits::bits();
    const int last = is_near ? -bits / 2 - 8 : 24 - bits;
    int step_bits = 64;
    if (is_near) { // the step that gives ordinary rows their 106 bits
        double own[9];
        double correction[4];
        load(numbers, own);
        newton_step<DoubleDouble>(own, start, StepBase(own, start), correction);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = q[k] + Careful(correction[k]);
        }
        step_bits = 128;
    }
    bool is_small = false;
    for (int step = 0; step < 100 && !is_small; ++step) {
        step_bits = 2 * step_bits < bits ? 2 * step_bits : bits;
        const StepBase<Careful> base = [&] {
            const Wide::Bits half(step_bits / 2 + 32);
            const auto cut = [](const Careful& number) { return (number + Careful(0.0)).middle(); };
            StepBase<Careful> found(m, {cut(q[0]), cut(q[1]), cut(q[2]), cut(q[3])});
            found.mu = found.mu.middle(); // any will do
            return found;
        }();
        const Wide::Bits some(step_bits + 32);
        Careful correction[4];
        newton_step<Careful>(m, q, base, correction);
        is_small = step_bits == bits;
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = (q[k] + correction[k]).middle();
            is_small = is_small && correction[k].is_below(last);
        }
    }
    const Davenport<Careful> k(m);
    for (unsigned i = 0; i < 4; ++i) {
        if (start[i] != 0.0 || !k.stands_alone(i)) {
            q[i].widen(Careful(1.0).shifted(is_small ? 26 - bits : 0));
        }
    }
}

/// Improves the quaternion of read_clean() where one power step may not be enough. Far from a rotation it is still to
/// be refined.
Error read_unclean_matrix(const double (&m)[9], double square, double (&q)[4], double& defect) noexcept {
    if (!all_finite(m, 9)) {
        return Error::not_finite;
    }
    if (is_far(square)) {
        double factor[9] = {};
        const Error error = polar_factor(m, factor, defect);
        read_clean(factor, q);
        return error;
    }
    const Davenport<double> k(m);
    const double bound = 3.0 * root(square);
    double remaining = bound * bound;
    while (remaining > 0x1p-56) {
        k.take_power_step(q);
        remaining *= bound;
    }
    const double scale = unit_scale(root(squared_norm(q)));
    for (double& component : q) {
        component *= scale;
    }
    defect = bound <= reported_defect ? bound : defect_of_matrix(m);
    return Error::none;
}

struct Matrix : WrittenByFormula<Matrix, 9> {
    ROTCONV_INLINE static ErrorBound error_of(const double (&/*q*/)[4], double off) noexcept {
        return error_of_entries(off);
    }
    ROTCONV_INLINE static double first_error_of(double off) noexcept { return first_error_of_entries(off); }
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&numbers)[9]) noexcept {
        scaled_matrix_of(q, numbers);
        divide_entries(numbers, squared_norm(q));
    }

    /// Any matrix, in double. `square`: its squared distance.
    static Error read_in_double(const double* numbers, double (&q)[4], double& defect, double& square) noexcept {
        double m[9];
        load(numbers, m);
        defect = clean_defect;
        square = read_clean(m, q);
        return square <= clean_square ? Error::none : read_unclean_matrix(m, square, q, defect);
    }

    static Error read_one(const Spec& /*spec*/, const double* numbers, double (&q)[4], double& defect) noexcept {
        double square = 0.0;
        const Error error = read_in_double(numbers, q, defect, square);
        if (is_far(square) && error == Error::none) [[unlikely]] {
            DoubleDouble exact[4];
            refine(numbers, q, exact);
            load(exact, q);
        }
        return error;
    }

    static void read_carefully(const Spec& /*spec*/, const double* numbers, Careful (&q)[4]) noexcept {
        double near[4];
        double defect = 0.0;
        double square = 0.0;
        read_in_double(numbers, near, defect, square);
        refine(numbers, near, !is_far(square), q);
    }

    template <class T> static void read(const Spec& /*spec*/, const double* numbers, std::size_t rows,
                                        AttitudeBatch<T>& attitudes) noexcept {
        Columns<double, 9> columns;
        Columns<double, 4> near;
        double square[batch_rows];
        to_columns(numbers, rows, columns);
        for (std::size_t i = 0; i < rows; ++i) {
            double m[9];
            double q[4];
            columns.get(i, m);
            square[i] = read_clean(m, q);
            near.set(i, q);
            attitudes.defect[i] = clean_defect;
            attitudes.off[i] = 0x1p-95;
        }
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = Error::none;
            if (!(square[i] <= clean_square)) [[unlikely]] {
                double m[9];
                double q[4];
                columns.get(i, m);
                near.get(i, q);
                attitudes.error[i] = read_unclean_matrix(m, square[i], q, attitudes.defect[i]);
                near.set(i, q);
            }
        }
        for (std::size_t i = 0; i < rows; ++i) {
            double q[4];
            near.get(i, q);
            if constexpr (std::is_same_v<T, double>) {
                attitudes.set(i, q);
            } else {
                double m[9];
                double correction[4];
                columns.get(i, m);
                newton_step<DoubleDouble>(m, q, StepBase(m, q), correction);
                attitudes.set(i, {two_sum(q[0], correction[0]), two_sum(q[1], correction[1]),
                                  two_sum(q[2], correction[2]), two_sum(q[3], correction[3])});
            }
        }
        for (std::size_t i = 0; i < rows; ++i) {
            if (is_far(square[i]) && attitudes.error[i] == Error::none) [[unlikely]] {
                double start[4];
                DoubleDouble q[4];
                near.get(i, start);
                refine(numbers + 9 * i, start, q);
                attitudes.off[i] = 1.0;
                for (std::size_t k = 0; k < 4; ++k) {
                    attitudes[k].set(i, rounded_to<T>(q[k]));
                }
            }
        }
    }

    /// Matrices of fewer than 12 digits are left open; a batch of nothing else is not worth the rest.
    static bool read_first(const Spec& /*spec*/, const double* numbers, std::size_t rows,
                           AttitudeBatch<double>& attitudes, std::uint64_t* doubts) noexcept {
        Columns<double, 9> columns;
        FirstNumbers<4> first;
        to_columns(numbers, rows, columns);
        for (std::size_t i = 0; i < rows; ++i) {
            double m[9];
            columns.get(i, m);
            first.off[i] = first_error_of_quaternion(squared_distance(m));
            attitudes.defect[i] = clean_defect;
        }
        if (all(first.off, rows, [](double off) { return !(off < FirstNumbers<4>::largest_off); })) {
            return false;
        }
        for (std::size_t i = 0; i < rows; ++i) {
            double m[9];
            Fixed q[4];
            columns.get(i, m);
            unit_quaternion_of(m, q);
            first.set(i, q, attitudes);
        }
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = Error::none;
        }
        first.find_doubts(attitudes, rows, doubts);
        return true;
    }
};

} // namespace

constinit const Kernel kernels::dcm = []() noexcept {
    Kernel kernel = kernel_of_formula<Matrix>;
    kernel.column = Matrix::size;
    if (ROTCONV_HAS_FMA != 0) { // elsewhere they gain nothing
        kernel.read_first = Matrix::read_first;
        kernel.write_first = Matrix::write_first;
        kernel.first_takes_any_size = true; // what is lost below 2^-960 is nothing beside them
    }
    return kernel;
}();

} // namespace ROTCONV_TARGET
} // namespace rotconv
