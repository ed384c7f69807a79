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

namespace bench {
namespace {

using rotconv::EulerSequence;
using rotconv::RepresentationId;

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using In = Eigen::Map<const Matrix>;
using Out = Eigen::Map<Matrix>;
using Vector = Eigen::Vector3d;

Eigen::Quaterniond quaternion(const double* q) { return {q[0], q[1], q[2], q[3]}; }
Vector vector(const double* v) { return {v[0], v[1], v[2]}; }
void store(const Vector& v, double* out) { Eigen::Map<Vector>{out} = v; }

template <std::size_t Inputs, std::size_t Outputs, class OneRow>
void each(const double* in, std::size_t rows, double* out, OneRow one_row) noexcept {
    for (std::size_t i = 0; i < rows; ++i, in += Inputs, out += Outputs) {
        one_row(in, out);
    }
}

void eigen_dcm_quat(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 4>(in, rows, out, [](const double* m, double* to) {
        const Eigen::Quaterniond q(In{m});
        to[0] = q.w();
        store(q.vec(), to + 1);
    });
}

void eigen_dcm_rotvec(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 3>(in, rows, out, [](const double* m, double* to) {
        const Eigen::AngleAxisd a(In{m});
        store(a.angle() * a.axis(), to);
    });
}

void eigen_dcm_cayley(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 3>(in, rows, out, [](const double* m, double* to) {
        const Eigen::Quaterniond q(In{m});
        store(q.vec() / q.w(), to);
    });
}

/// The unit quaternion that Eigen's conversions ask for, of any length or of length 1 already.
template <bool hostile> Eigen::Quaterniond unit_quaternion(const double* q) {
    return hostile ? quaternion(q).normalized() : quaternion(q);
}

template <bool hostile>
void eigen_quat_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 9>(in, rows, out,
               [](const double* q, double* to) { Out{to} = unit_quaternion<hostile>(q).toRotationMatrix(); });
}

template <bool hostile>
void eigen_quat_rotvec(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 3>(in, rows, out, [](const double* q, double* to) {
        const Eigen::AngleAxisd a(unit_quaternion<hostile>(q));
        store(a.angle() * a.axis(), to);
    });
}

template <bool hostile>
void eigen_quat_euler(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    // constant axes, as in a program that knows its sequence
    if (sequence.proper()) {
        each<4, 3>(in, rows, out, [](const double* q, double* to) {
            store(unit_quaternion<hostile>(q).toRotationMatrix().eulerAngles(2, 0, 2), to);
        });
    } else {
        each<4, 3>(in, rows, out, [](const double* q, double* to) {
            store(unit_quaternion<hostile>(q).toRotationMatrix().eulerAngles(2, 1, 0), to);
        });
    }
}

void eigen_rotvec_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [](const double* v, double* to) {
        const Vector r = vector(v);
        Out{to} = Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix();
    });
}

void eigen_cayley_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [](const double* c, double* to) {
        Out{to} = Eigen::Quaterniond(1.0, c[0], c[1], c[2]).normalized().toRotationMatrix();
    });
}

void eigen_euler_dcm(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    using Turn = Eigen::AngleAxisd;
    if (sequence.proper()) {
        each<3, 9>(in, rows, out, [](const double* e, double* to) {
            Out{to} = (Turn(e[0], Vector::UnitZ()) * Turn(e[1], Vector::UnitX()) * Turn(e[2], Vector::UnitZ()))
                          .toRotationMatrix();
        });
    } else {
        each<3, 9>(in, rows, out, [](const double* e, double* to) {
            Out{to} = (Turn(e[0], Vector::UnitZ()) * Turn(e[1], Vector::UnitY()) * Turn(e[2], Vector::UnitX()))
                          .toRotationMatrix();
        });
    }
}

void typed_dcm_quat(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 4>(in, rows, out, [](const double* m, double* to) {
        const Eigen::Quaterniond q = rotconv::quaternion::from_rotation(*rotconv::dcm::to_rotation(In{m}));
        to[0] = q.w();
        store(q.vec(), to + 1);
    });
}

void typed_dcm_rotvec(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 3>(in, rows, out, [](const double* m, double* to) {
        store(rotconv::rotation_vector::from_rotation(*rotconv::dcm::to_rotation(In{m})).vector, to);
    });
}

void typed_dcm_cayley(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 3>(in, rows, out, [](const double* m, double* to) {
        store(rotconv::cayley::from_rotation(*rotconv::dcm::to_rotation(In{m})), to);
    });
}

void typed_quat_rotvec(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 3>(in, rows, out, [](const double* q, double* to) {
        store(rotconv::rotation_vector::from_rotation(*rotconv::quaternion::to_rotation(quaternion(q))).vector, to);
    });
}

void typed_quat_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 9>(in, rows, out, [](const double* q, double* to) {
        Out{to} = rotconv::dcm::from_rotation(*rotconv::quaternion::to_rotation(quaternion(q)));
    });
}

void typed_quat_euler(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 3>(in, rows, out, [sequence](const double* q, double* to) {
        store(rotconv::euler::from_rotation(*rotconv::quaternion::to_rotation(quaternion(q)), sequence).angles, to);
    });
}

void typed_rotvec_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [](const double* r, double* to) {
        Out{to} = rotconv::dcm::from_rotation(*rotconv::rotation_vector::to_rotation({vector(r)}));
    });
}

void typed_cayley_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [](const double* c, double* to) {
        Out{to} = rotconv::dcm::from_rotation(*rotconv::cayley::to_rotation(vector(c)));
    });
}

void typed_euler_dcm(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [sequence](const double* e, double* to) {
        Out{to} = rotconv::dcm::from_rotation(*rotconv::euler::to_rotation({vector(e), sequence}));
    });
}

using Ways = std::map<std::pair<RepresentationId, RepresentationId>, Run>;

Run find(const Ways& ways, RepresentationId from, RepresentationId to) {
    const auto found = ways.find({from, to});
    return found == ways.end() ? nullptr : found->second;
}

} // namespace

Run eigen_way(RepresentationId from, RepresentationId to, bool hostile) {
    const Ways ways{
        {{RepresentationId::dcm, RepresentationId::quat}, eigen_dcm_quat},
        {{RepresentationId::dcm, RepresentationId::rotvec}, eigen_dcm_rotvec},
        {{RepresentationId::dcm, RepresentationId::cayley}, eigen_dcm_cayley},
        {{RepresentationId::quat, RepresentationId::dcm}, hostile ? eigen_quat_dcm<true> : eigen_quat_dcm<false>},
        {{RepresentationId::quat, RepresentationId::rotvec},
         hostile ? eigen_quat_rotvec<true> : eigen_quat_rotvec<false>},
        {{RepresentationId::quat, RepresentationId::euler}, hostile ? eigen_quat_euler<true> : eigen_quat_euler<false>},
        {{RepresentationId::rotvec, RepresentationId::dcm}, eigen_rotvec_dcm},
        {{RepresentationId::cayley, RepresentationId::dcm}, eigen_cayley_dcm},
        {{RepresentationId::euler, RepresentationId::dcm}, eigen_euler_dcm},
    };
    return find(ways, from, to);
}

Run typed_way(RepresentationId from, RepresentationId to) {
    static const Ways ways{
        {{RepresentationId::dcm, RepresentationId::quat}, typed_dcm_quat},
        {{RepresentationId::dcm, RepresentationId::rotvec}, typed_dcm_rotvec},
        {{RepresentationId::dcm, RepresentationId::cayley}, typed_dcm_cayley},
        {{RepresentationId::quat, RepresentationId::dcm}, typed_quat_dcm},
        {{RepresentationId::quat, RepresentationId::rotvec}, typed_quat_rotvec},
        {{RepresentationId::quat, RepresentationId::euler}, typed_quat_euler},
        {{RepresentationId::rotvec, RepresentationId::dcm}, typed_rotvec_dcm},
        {{RepresentationId::cayley, RepresentationId::dcm}, typed_cayley_dcm},
        {{RepresentationId::euler, RepresentationId::dcm}, typed_euler_dcm},
    };
    return find(ways, from, to);
}

} // namespace bench
