// Conversions as a C++ program writes them, one row at a time.

#include "ways.hpp"

#include <map>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <rotconv/cayley.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rotation_vector.hpp>
#include <rotconv/two_column.hpp>

namespace bench {
namespace {

using rotconv::RepresentationId;
using rotconv::Rotation;
using Sequence = rotconv::EulerSequence;

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;
using Turn = Eigen::AngleAxisd;

Eigen::Map<const Matrix> matrix(const double* m) { return Eigen::Map<const Matrix>(m); }
Quaternion quaternion(const double* q) { return {q[0], q[1], q[2], q[3]}; }
Vector vector(const double* v) { return {v[0], v[1], v[2]}; }
void store(const Matrix& m, double* out) { Eigen::Map<Matrix>{out} = m; }
void store(const Vector& v, double* out) { Eigen::Map<Vector>{out} = v; }
void store(const Quaternion& q, double* out) {
    out[0] = q.w();
    store(Vector(q.vec()), out + 1);
}

template <std::size_t inputs, auto read, std::size_t outputs, auto write>
void each(Sequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    for (std::size_t i = 0; i < rows; ++i, in += inputs, out += outputs) {
        store(write(read(in, sequence), sequence), out);
    }
}

using Ways = std::map<std::pair<RepresentationId, RepresentationId>, Run>;

Run find(const Ways& ways, RepresentationId from, RepresentationId to) {
    const auto found = ways.find({from, to});
    return found == ways.end() ? nullptr : found->second;
}

namespace by_eigen {

constexpr auto from_dcm = [](const double* m, Sequence) { return Quaternion(matrix(m)); };
constexpr auto as_it_is = [](const double* m, Sequence) { return matrix(m); };
/// Eigen's conversions ask for unit quaternions.
constexpr auto from_unit_quat = [](const double* q, Sequence) { return quaternion(q); };
constexpr auto from_any_quat = [](const double* q, Sequence) { return quaternion(q).normalized(); };
constexpr auto from_rotvec = [](const double* v, Sequence) { return Turn(vector(v).norm(), vector(v).normalized()); };
constexpr auto from_cayley = [](const double* c, Sequence) { return Quaternion(1.0, c[0], c[1], c[2]).normalized(); };
// constant axes, as in a program that knows its sequence
constexpr auto from_euler = [](const double* e, Sequence sequence) {
    return sequence.proper() ? Turn(e[0], Vector::UnitZ()) * Turn(e[1], Vector::UnitX()) * Turn(e[2], Vector::UnitZ())
                             : Turn(e[0], Vector::UnitZ()) * Turn(e[1], Vector::UnitY()) * Turn(e[2], Vector::UnitX());
};
constexpr auto to_quat = [](const auto& turn, Sequence) { return Quaternion(turn); };
constexpr auto to_dcm = [](const auto& turn, Sequence) { return Matrix(turn.toRotationMatrix()); };
constexpr auto to_rotvec = [](const Quaternion& q, Sequence) {
    const Turn turn(q);
    return Vector(turn.angle() * turn.axis());
};
constexpr auto to_cayley = [](const Quaternion& q, Sequence) { return Vector(q.vec() / q.w()); };
constexpr auto to_euler = [](const auto& attitude, Sequence sequence) {
    const Eigen::Matrix3d m(attitude);
    return sequence.proper() ? m.eulerAngles(2, 0, 2) : m.eulerAngles(2, 1, 0);
};

template <auto from_quat> Ways ways() {
    using enum RepresentationId;
    return {{{dcm, quat}, each<9, from_dcm, 4, to_quat>},       {{dcm, rotvec}, each<9, from_dcm, 3, to_rotvec>},
            {{dcm, cayley}, each<9, from_dcm, 3, to_cayley>},   {{quat, dcm}, each<4, from_quat, 9, to_dcm>},
            {{quat, rotvec}, each<4, from_quat, 3, to_rotvec>}, {{quat, euler}, each<4, from_quat, 3, to_euler>},
            {{rotvec, dcm}, each<3, from_rotvec, 9, to_dcm>},   {{cayley, dcm}, each<3, from_cayley, 9, to_dcm>},
            {{euler, dcm}, each<3, from_euler, 9, to_dcm>},     {{dcm, euler}, each<9, as_it_is, 3, to_euler>},
            {{rotvec, quat}, each<3, from_rotvec, 4, to_quat>}, {{euler, quat}, each<3, from_euler, 4, to_quat>}};
}

} // namespace by_eigen

namespace typed {

namespace set = rotconv;

constexpr auto from_dcm = [](const double* m, Sequence) { return *set::dcm::to_rotation(matrix(m), set::any_defect); };
constexpr auto from_6d = [](const double* m, Sequence) {
    return *set::two_column::to_rotation(Eigen::Map<const set::TwoColumns>(m), set::any_defect);
};
constexpr auto from_quat = [](const double* q, Sequence) {
    return *set::quaternion::to_rotation(quaternion(q), set::any_defect);
};
constexpr auto from_rotvec = [](const double* v, Sequence) { return *set::rotation_vector::to_rotation({vector(v)}); };
constexpr auto from_cayley = [](const double* c, Sequence) { return *set::cayley::to_rotation(vector(c)); };
constexpr auto from_euler = [](const double* e, Sequence s) {
    return *set::euler::to_rotation({vector(e), s, set::AngleUnit::radians});
};
constexpr auto to_quat = [](const Rotation& r, Sequence) { return set::quaternion::from_rotation(r); };
constexpr auto to_dcm = [](const Rotation& r, Sequence) { return Matrix(set::dcm::from_rotation(r)); };
constexpr auto to_rotvec = [](const Rotation& r, Sequence) { return set::rotation_vector::from_rotation(r).vector; };
constexpr auto to_cayley = [](const Rotation& r, Sequence) { return set::cayley::from_rotation(r); };
constexpr auto to_euler = [](const Rotation& r, Sequence s) { return Vector(set::euler::from_rotation(r, s).angles); };

Ways ways() {
    using enum RepresentationId;
    return {{{dcm, quat}, each<9, from_dcm, 4, to_quat>},       {{dcm, rotvec}, each<9, from_dcm, 3, to_rotvec>},
            {{dcm, cayley}, each<9, from_dcm, 3, to_cayley>},   {{quat, dcm}, each<4, from_quat, 9, to_dcm>},
            {{quat, rotvec}, each<4, from_quat, 3, to_rotvec>}, {{quat, euler}, each<4, from_quat, 3, to_euler>},
            {{rotvec, dcm}, each<3, from_rotvec, 9, to_dcm>},   {{cayley, dcm}, each<3, from_cayley, 9, to_dcm>},
            {{euler, dcm}, each<3, from_euler, 9, to_dcm>},     {{dcm, euler}, each<9, from_dcm, 3, to_euler>},
            {{rotvec, quat}, each<3, from_rotvec, 4, to_quat>}, {{euler, quat}, each<3, from_euler, 4, to_quat>},
            {{two_column, dcm}, each<6, from_6d, 9, to_dcm>}};
}

} // namespace typed

} // namespace

Run eigen_way(RepresentationId from, RepresentationId to, bool hostile) {
    return find(hostile ? by_eigen::ways<by_eigen::from_any_quat>() : by_eigen::ways<by_eigen::from_unit_quat>(), from,
                to);
}

Run typed_way(RepresentationId from, RepresentationId to) { return find(typed::ways(), from, to); }

} // namespace bench
