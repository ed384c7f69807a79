#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <rotconv/version.hpp>

namespace rotconv {

/// Whether a number is neither nan nor infinite, by its bits: a check that -ffast-math does not remove.
[[nodiscard]] inline bool has_finite_bits(double number) noexcept {
    return (std::bit_cast<std::uint64_t>(number) >> 52U & 0x7ffU) != 0x7ffU;
}

/// The product rounded, not fused with a sum, whatever flags the caller is compiled with: fused, differences that are 0
/// at quarter turns would not be 0.
[[nodiscard, gnu::always_inline]] inline double rounded_product(double a, double b) noexcept {
#if defined(__clang__)
    _Pragma("clang fp contract(off)") return a * b;
#elif defined(__GNUC__) && __GNUC__ >= 12
    return __builtin_assoc_barrier(a * b);
#else
    return a * b;
#endif
}

/// |q|^2 of any quaternion.
[[nodiscard, gnu::always_inline]] inline double squared_norm(double w, double x, double y, double z) noexcept {
    return (rounded_product(w, w) + rounded_product(x, x)) + (rounded_product(y, y) + rounded_product(z, z));
}

/// A matrix of Eigen whose size is known only at run time.
template <class Matrix>
concept DynamicMatrix = std::derived_from<Matrix, Eigen::MatrixBase<Matrix>> &&
                        int(Matrix::SizeAtCompileTime) == int(Eigen::Dynamic);

/// @throw std::invalid_argument with both sizes
[[noreturn]] void throw_size(Eigen::Index rows, Eigen::Index columns, int needed_rows, int needed_columns);

/// The matrix as one of a fixed size. A wrong size does not compile, or throws where it is known only at run time.
/// @throw std::invalid_argument if the matrix has another size
template <class Fixed, class Derived> [[nodiscard]] Fixed sized(const Eigen::MatrixBase<Derived>& matrix) {
    if (matrix.rows() != Fixed::RowsAtCompileTime || matrix.cols() != Fixed::ColsAtCompileTime) [[unlikely]] {
        throw_size(matrix.rows(), matrix.cols(), Fixed::RowsAtCompileTime, Fixed::ColsAtCompileTime);
    }
    return matrix;
}

/// The one internal form of a rotation (eps in all bounds of these headers is 2^-52, in radians of attitude): a nonzero
/// quaternion (w, x, y, z), Hamilton product, active, body to reference
/// (`v_ref = R_ref_body * v_body`).
///
/// The quaternion is *not* normalised: each representation divides by the norm itself, which saves half an eps. All
/// four components are finite, and |q|^2 is in [1/4, 4): larger and smaller quaternions are scaled by a power of two,
/// which is exact. Both signs of q are the same rotation.
class Rotation {
public:
    /// The identity.
    constexpr Rotation() noexcept = default;

    /// The rotation nearest to a 3x3 matrix, as by dcm::to_rotation(), which returns an error instead of throwing it.
    /// @throw std::logic_error if there is none
    explicit Rotation(const Eigen::Matrix3d& matrix);
    explicit Rotation(const DynamicMatrix auto& matrix) : Rotation(sized<Eigen::Matrix3d>(matrix)) {}

    /// The rotation of a finite nonzero quaternion of any norm and either sign. Exact, except that components more than
    /// 2^1074 times smaller than the largest become 0.
    /// @throw std::invalid_argument if all components are 0 or one is not finite
    static Rotation from_components(double w, double x, double y, double z) {
        const double square = rotconv::squared_norm(w, x, y, z);
        if (!(square > 0x1p-900 && square < 0x1p900)) [[unlikely]] {
            return scaled(w, x, y, z);
        }
        return with_square(square, w, x, y, z);
    }

    /// The same for a quaternion with |q|^2 in [1/4, 4). Exact.
    static Rotation near_unit(double w, double x, double y, double z) noexcept {
        assert(!(rotconv::squared_norm(w, x, y, z) < 0.25) && !(rotconv::squared_norm(w, x, y, z) >= 4.0));
        return {w, x, y, z};
    }

    [[nodiscard]] double w() const noexcept { return q_[0]; }
    [[nodiscard]] double x() const noexcept { return q_[1]; }
    [[nodiscard]] double y() const noexcept { return q_[2]; }
    [[nodiscard]] double z() const noexcept { return q_[3]; }
    /// w, x, y, z.
    [[nodiscard]] const std::array<double, 4>& components() const noexcept { return q_; }
    /// Component of the vector part along `axis` 0, 1, 2.
    [[nodiscard]] double along(int axis) const noexcept { return q_[static_cast<std::size_t>(axis) + 1]; }

    /// |q|^2, in [1/4, 4).
    [[nodiscard]] double squared_norm() const noexcept { return rotconv::squared_norm(q_[0], q_[1], q_[2], q_[3]); }

    /// |(x, y, z)| with full relative accuracy at any size: 0 only if the vector part is exactly 0.
    [[nodiscard]] double vector_length() const noexcept;

    [[nodiscard]] bool is_identity() const noexcept { return q_[1] == 0.0 && q_[2] == 0.0 && q_[3] == 0.0; }

    /// 1 or -1: the factor that makes the sign canonical, which means that w > 0, or that w = 0 and the first nonzero
    /// of x, y, z is positive.
    [[nodiscard]] double sign() const noexcept {
        const double vector_leader = q_[1] != 0.0 ? q_[1] : (q_[2] != 0.0 ? q_[2] : q_[3]);
        return std::copysign(1.0, q_[0] != 0.0 ? q_[0] : vector_leader);
    }

    /// The same rotation with the canonical sign.
    [[nodiscard]] Rotation canonical() const noexcept {
        const double factor = sign();
        return {q_[0] * factor, q_[1] * factor, q_[2] * factor, q_[3] * factor};
    }

    /// The inverse rotation (reference to body). Exact.
    [[nodiscard]] Rotation inverse() const noexcept { return {q_[0], -q_[1], -q_[2], -q_[3]}; }

    /// The composition, R_ref_body = R_ref_a * R_a_body. Worst error found: 3.63 eps, limit 4.25.
    friend Rotation operator*(const Rotation& a, const Rotation& b) noexcept {
        // Callers have flags of their own: a sum of products may be fused.
        const double w = (a.w() * b.w() - a.x() * b.x()) - (a.y() * b.y() + a.z() * b.z());
        const double x = (a.w() * b.x() + a.x() * b.w()) + (a.y() * b.z() - a.z() * b.y());
        const double y = (a.w() * b.y() + a.y() * b.w()) + (a.z() * b.x() - a.x() * b.z());
        const double z = (a.w() * b.z() + a.z() * b.w()) + (a.x() * b.y() - a.y() * b.x());
        return with_square((w * w + x * x) + (y * y + z * z), w, x, y, z); // in [1/16, 16)
    }

    /// Whether both are the same attitude exactly, whatever the signs and norms of the quaternions. What was computed
    /// in two ways is seldom the same to the last bit: see angle_between().
    friend bool operator==(const Rotation& a, const Rotation& b) noexcept;

    /// Turns a vector, or each column of a matrix with three rows: v_ref = R_ref_body * v_body = v + 2 (w u x v + u x
    /// (u x v))/|q|^2 with u = (x, y, z). Worst error found: 9.24 eps of the vector's length, limit 10.75.
    /// @throw std::invalid_argument if the matrix, with a size known only at run time, has not three rows
    template <class Derived> friend Eigen::Matrix<double, 3, Derived::ColsAtCompileTime>
    operator*(const Rotation& rotation, const Eigen::MatrixBase<Derived>& vectors) {
        static_assert(int(Derived::RowsAtCompileTime) == 3 || int(Derived::RowsAtCompileTime) == int(Eigen::Dynamic),
                      "a rotation turns vectors of three numbers: the columns of a matrix with three rows");
        if (vectors.rows() != 3) [[unlikely]] {
            throw_size(vectors.rows(), vectors.cols(), 3, static_cast<int>(vectors.cols()));
        }
        const auto& columns = vectors.eval();
        const Eigen::Vector3d u{rotation.x(), rotation.y(), rotation.z()};
        const double factor = 2.0 / rotation.squared_norm();
        Eigen::Matrix<double, 3, Derived::ColsAtCompileTime> turned(3, vectors.cols());
        for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
            const Eigen::Vector3d v = columns.col(i).template head<3>();
            const Eigen::Vector3d across = u.cross(v);
            turned.col(i) = v + factor * (rotation.w() * across + u.cross(across));
        }
        return turned;
    }

private:
    Rotation(double w, double x, double y, double z) noexcept : q_{w, x, y, z} {}
    /// The rotation of a quaternion whose |q|^2, `square`, does not overflow and is not tiny.
    static Rotation with_square(double square, double w, double x, double y, double z) noexcept {
        // times 2^-n with 4^n <= |q|^2 < 4^(n + 1)
        const auto exponent = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(square) >> 52U) - 1023;
        const auto factor = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - (exponent >> 1)) << 52U);
        return {w * factor, x * factor, y * factor, z * factor};
    }
    static Rotation scaled(double w, double x, double y, double z);

    std::array<double, 4> q_{1.0, 0.0, 0.0, 0.0};
};

/// The unit quaternion w x y z, with the canonical sign.
std::ostream& operator<<(std::ostream& out, const Rotation& rotation);

/// The angle in [0, pi], in radians, of the rotation from `b` to `a`. Max error: 4 eps of the angle, and the rounding
/// of the product a b^-1.
[[nodiscard]] double angle_between(const Rotation& a, const Rotation& b) noexcept;

/// The attitude a (a^-1 b)^fraction, on the shortest rotation from `a` to `b`, by slerp (Shoemake 1985): (sin((1 - f)
/// h) p + sin(f h) q)/sin h with unit quaternions p, q of the same side and the angle h between them. It has the digits
/// of `a` if both are the same, and is otherwise a unit quaternion to rounding. Max error: 4 eps. The same bits on
/// every machine. Nothing if the two are half a turn apart to rounding, |p.q| <= 4 eps: no rotation between them is
/// then the shortest.
/// @throw std::invalid_argument if the fraction is not in [0, 1]
[[nodiscard]] std::optional<Rotation> interpolate(const Rotation& a, const Rotation& b, double fraction);

/// The axes in which an angular velocity is given: w_ref = R w_body. The angular velocity is always that of the body
/// relative to the reference, in radians a second: Rdot = R [w_body]_x = [w_ref]_x R (Stuelpnagel 1964, section 1: Xdot
/// = Omega X with X = R' and Omega = -[w_body]_x).
enum class Frame : std::uint8_t { body, reference };

} // namespace rotconv
