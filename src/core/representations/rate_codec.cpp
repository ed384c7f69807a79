#include "rate_codec.hpp"

#include <algorithm>
#include <array>

#include <rotconv/cayley.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/mrp.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rates.hpp>
#include <rotconv/rotation_vector.hpp>
#include <rotconv/two_column.hpp>

#include "../enum_table.hpp"

// Each struct below fits one representation to rows of plain numbers.

namespace rotconv {
namespace {

using Eigen::Map;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// A representation whose numbers are one fixed-size matrix and know neither unit nor sequence.
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
using SixDRates = PlainRates<Columns, &two_column::rate, &two_column::angular_velocity>;
using FiveDRates = PlainRates<five_d::Vector5, &five_d::rate, &five_d::angular_velocity>;
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
    static Sensitivity sensitivity(const Spec& spec, const double* v, const Rotation& rotation) noexcept {
        return rotation_vector::sensitivity({{v[0], v[1], v[2]}, spec.unit}, rotation);
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

template <class Adapter> constexpr RateCodec codec_for() noexcept {
    if constexpr (requires { &Adapter::sensitivity; }) {
        return {&Adapter::rate, &Adapter::angular_velocity, &Adapter::sensitivity};
    } else {
        return {&Adapter::rate, &Adapter::angular_velocity, nullptr};
    }
}

struct NamedCodec {
    RepresentationId name;
    RateCodec codec;
};
constexpr auto codecs = std::to_array<NamedCodec>({
    {RepresentationId::dcm, codec_for<DcmRates>()},
    {RepresentationId::two_column, codec_for<SixDRates>()},
    {RepresentationId::five_d, codec_for<FiveDRates>()},
    {RepresentationId::quat, codec_for<QuatRates>()},
    {RepresentationId::axis_angle, {}},
    {RepresentationId::rotvec, codec_for<RotvecRates>()},
    {RepresentationId::euler, codec_for<EulerRates>()},
    {RepresentationId::rpy, codec_for<EulerRates>()},
    {RepresentationId::cayley, codec_for<CayleyRates>()},
    {RepresentationId::mrp, codec_for<MrpRates>()},
});
static_assert(is_indexed(codecs, representation_count, &NamedCodec::name));

} // namespace

const RateCodec& rate_codec_of(RepresentationId name) noexcept { return codecs[static_cast<std::size_t>(name)].codec; }

bool has_rates(RepresentationId name) noexcept { return rate_codec_of(name).rate != nullptr; }

} // namespace rotconv
