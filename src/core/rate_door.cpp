#include "rate_door.hpp"

#include <algorithm>
#include <array>

#include <rotconv/cayley.hpp>
#include <rotconv/columns.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/mrp.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/rotation_vector.hpp>

#include "enum_table.hpp"

// Each struct below fits one room to rows of plain numbers.

namespace rotconv {
namespace {

using Eigen::Map;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// A room whose numbers are one fixed-size matrix and know neither unit nor sequence.
template <class Numbers, auto Rate, auto Velocity> struct PlainRates {
    // NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
    static void rate(const Spec& /*spec*/, const double* v, const Vector3d& w, Frame frame, double* rates) noexcept {
        Map<Numbers>{rates} = Rate(Map<const Numbers>(v), w, frame);
    }
    static Vector3d angular_velocity(const Spec& /*spec*/, const double* v, const double* rates, Frame frame) noexcept {
        return Velocity(Map<const Numbers>(v), Map<const Numbers>(rates), frame);
    }
};

using DcmRates = PlainRates<RowMajor, &dcm::rate, &dcm::angular_velocity>;
using SixDRates = PlainRates<Columns, &columns::rate, &columns::angular_velocity>;
using FiveDRates = PlainRates<hopf::Vector5, &hopf::rate, &hopf::angular_velocity>;
using CayleyRates = PlainRates<Vector3d, &cayley::rate, &cayley::angular_velocity>;
using MrpRates = PlainRates<Vector3d, &mrp::rate, &mrp::angular_velocity>;

struct QuatRates {
    static void rate(const Spec& /*spec*/, const double* v, const Vector3d& w, Frame frame, double* rates) noexcept {
        const Quaternion q = quaternion::rate({v[0], v[1], v[2], v[3]}, w, frame);
        rates[0] = q.w;
        rates[1] = q.x;
        rates[2] = q.y;
        rates[3] = q.z;
    }
    static Vector3d angular_velocity(const Spec& /*spec*/, const double* v, const double* rates, Frame frame) noexcept {
        return quaternion::angular_velocity({v[0], v[1], v[2], v[3]}, {rates[0], rates[1], rates[2], rates[3]}, frame);
    }
};

struct RotvecRates {
    // NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
    static void rate(const Spec& spec, const double* v, const Vector3d& w, Frame frame, double* rates) noexcept {
        Map<Vector3d>{rates} = rotation_vector::rate({{v[0], v[1], v[2]}, spec.unit}, w, frame);
    }
    static Vector3d angular_velocity(const Spec& spec, const double* v, const double* rates, Frame frame) noexcept {
        return rotation_vector::angular_velocity({{v[0], v[1], v[2]}, spec.unit}, Map<const Vector3d>(rates), frame);
    }
    static Figures figures(const Spec& spec, const double* v, const Rotation& rotation) noexcept {
        return rotation_vector::figures({{v[0], v[1], v[2]}, spec.unit}, rotation);
    }
};

struct EulerRates {
    static void rate(const Spec& spec, const double* v, const Vector3d& w, Frame frame, double* rates) noexcept {
        std::ranges::copy(euler::rate({{v[0], v[1], v[2]}, spec.sequence, spec.unit}, w, frame), rates);
    }
    static Vector3d angular_velocity(const Spec& spec, const double* v, const double* rates, Frame frame) noexcept {
        return euler::angular_velocity({{v[0], v[1], v[2]}, spec.sequence, spec.unit}, {rates[0], rates[1], rates[2]},
                                       frame);
    }
};

template <class Room> constexpr RateDoor door_for() noexcept {
    if constexpr (requires { &Room::figures; }) {
        return {&Room::rate, &Room::angular_velocity, &Room::figures};
    } else {
        return {&Room::rate, &Room::angular_velocity, nullptr};
    }
}

struct NamedDoor {
    Name name;
    RateDoor door;
};
constexpr auto doors = std::to_array<NamedDoor>({
    {Name::dcm, door_for<DcmRates>()},
    {Name::six_d, door_for<SixDRates>()},
    {Name::five_d, door_for<FiveDRates>()},
    {Name::quat, door_for<QuatRates>()},
    {Name::axis_angle, {}},
    {Name::rotvec, door_for<RotvecRates>()},
    {Name::euler, door_for<EulerRates>()},
    {Name::rpy, door_for<EulerRates>()},
    {Name::cayley, door_for<CayleyRates>()},
    {Name::mrp, door_for<MrpRates>()},
});
static_assert(is_indexed(doors, name_count, &NamedDoor::name));

} // namespace

const RateDoor& rate_door_of(Name name) noexcept { return doors[static_cast<std::size_t>(name)].door; }

bool has_rates(Name name) noexcept { return rate_door_of(name).rate != nullptr; }

} // namespace rotconv
