#include "codec.hpp"

#include <array>

#include <rotconv/axis_angle.hpp>
#include <rotconv/cayley.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/mrp.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rotation_vector.hpp>
#include <rotconv/two_column.hpp>

#include "../enum_table.hpp"
#include "batches.hpp"

// Each struct below fits one representation to rows of plain numbers: `read` and `write` of one row, around which
// `codec_for` makes the loops, or `read_batch` and `write_batch`.

namespace rotconv {
namespace {

using Eigen::Map;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// A representation whose numbers are one fixed-size matrix and know neither unit nor sequence.
template <class Numbers, auto ToRotation, auto FromRotation, auto FiguresOf> struct PlainRow {
    static constexpr std::size_t size = Numbers::SizeAtCompileTime;
    static Reading read(const Spec& /*spec*/, const double* v) noexcept { return ToRotation(Map<const Numbers>(v)); }
    // NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
    static void write(const Rotation& r, double* v) noexcept { Map<Numbers>{v} = FromRotation(r); }
    static Sensitivity sensitivity(const Spec& /*spec*/, const Rotation& r) noexcept { return FiguresOf(r); }
};

struct DcmRow : PlainRow<RowMajor, &dcm::to_rotation, &dcm::from_rotation, &dcm::sensitivity> {
    static void read_batch(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        dcm::read(numbers, rows, readings);
    }
    static double exact_defect(const double* v) noexcept { return dcm::defect(Map<const RowMajor>(v)); }
};

struct SixDRow : PlainRow<Columns, &two_column::to_rotation, &two_column::from_rotation, &two_column::sensitivity> {
    static void read_batch(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        two_column::read(numbers, rows, readings);
    }
    static double exact_defect(const double* v) noexcept { return two_column::defect(Map<const Columns>(v)); }
};

struct FiveDRow : PlainRow<five_d::Vector5, &five_d::to_rotation, &five_d::from_rotation, &five_d::sensitivity> {
    static void read_batch(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        five_d::read(numbers, rows, readings);
    }
    static double exact_defect(const double* v) noexcept { return five_d::defect(Map<const five_d::Vector5>(v)); }
};

struct CayleyRow : PlainRow<Vector3d, &cayley::to_rotation, &cayley::from_rotation, &cayley::sensitivity> {
    static void write_batch(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, DiagnosticSet* diagnostics) noexcept {
        cayley::write(rotations, rows, numbers, diagnostics);
    }
};

struct MrpRow : PlainRow<Vector3d, &mrp::to_rotation, &mrp::from_rotation, &mrp::sensitivity> {
    static void write_batch(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, DiagnosticSet* diagnostics) noexcept {
        mrp::write(rotations, rows, numbers, diagnostics);
    }
};

struct QuatRow {
    static constexpr std::size_t size = 4;
    static Reading read(const Spec& /*spec*/, const double* v) noexcept {
        return quaternion::to_rotation({v[0], v[1], v[2], v[3]});
    }
    static double exact_defect(const double* v) noexcept { return quaternion::defect({v[0], v[1], v[2], v[3]}); }
    static void write_batch(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, DiagnosticSet* diagnostics) noexcept {
        quaternion::write(rotations, rows, numbers, diagnostics);
    }
    static Sensitivity sensitivity(const Spec& /*spec*/, const Rotation& r) noexcept {
        return quaternion::sensitivity(r);
    }
};

struct AxisAngleRow {
    static constexpr std::size_t size = 4;
    static Reading read(const Spec& spec, const double* v) noexcept {
        return axis_angle::to_rotation({{v[0], v[1], v[2]}, v[3], spec.unit});
    }
    static void write_batch(const Spec& spec, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, DiagnosticSet* diagnostics) noexcept {
        axis_angle::write(rotations, rows, spec.unit, numbers, diagnostics);
    }
    static Sensitivity sensitivity(const Spec& /*spec*/, const Rotation& r) noexcept {
        return axis_angle::sensitivity(r);
    }
};

struct RotvecRow {
    static void read_batch(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        rotation_vector::read(numbers, rows, spec.unit, readings);
    }
    static void write_batch(const Spec& spec, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, DiagnosticSet* diagnostics) noexcept {
        rotation_vector::write(rotations, rows, spec.unit, numbers, diagnostics);
    }
    static Sensitivity sensitivity(const Spec& /*spec*/, const Rotation& r) noexcept {
        return rotation_vector::sensitivity(r);
    }
};

struct EulerRow {
    static constexpr std::size_t size = 3;
    static Reading read(const Spec& spec, const double* v) noexcept {
        return euler::to_rotation({{v[0], v[1], v[2]}, spec.sequence, spec.unit});
    }
    static void write_batch(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows,
                            double* numbers, DiagnosticSet* diagnostics) noexcept {
        euler::write(rotations, rows, spec.sequence, spec.unit, lock_margin, numbers, diagnostics);
    }
    static Sensitivity sensitivity(const Spec& spec, const Rotation& r) noexcept {
        return euler::sensitivity(r, spec.sequence);
    }
};

template <class Row> constexpr Codec codec_for() noexcept {
    Codec codec{};
    if constexpr (requires { &Row::read_batch; }) {
        codec.read = &Row::read_batch;
    } else {
        codec.read = [](const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
            for (std::size_t i = 0; i < rows; ++i) {
                readings.set(i, Row::read(spec, numbers + i * Row::size));
            }
        };
    }
    if constexpr (requires { &Row::write_batch; }) {
        codec.write = &Row::write_batch;
    } else {
        codec.write = [](const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                         double* numbers, DiagnosticSet* diagnostics) noexcept {
            for (std::size_t i = 0; i < rows; ++i) {
                Row::write(rotations.at(i), numbers + i * Row::size);
                diagnostics[i] = {};
            }
        };
    }
    codec.sensitivity = &Row::sensitivity;
    if constexpr (requires { &Row::exact_defect; }) {
        codec.exact_defect = &Row::exact_defect;
    }
    return codec;
}

struct NamedCodec {
    RepresentationId name;
    Codec codec;
};
constexpr auto codecs = std::to_array<NamedCodec>({
    {RepresentationId::dcm, codec_for<DcmRow>()},
    {RepresentationId::two_column, codec_for<SixDRow>()},
    {RepresentationId::five_d, codec_for<FiveDRow>()},
    {RepresentationId::quat, codec_for<QuatRow>()},
    {RepresentationId::axis_angle, codec_for<AxisAngleRow>()},
    {RepresentationId::rotvec, codec_for<RotvecRow>()},
    {RepresentationId::euler, codec_for<EulerRow>()},
    {RepresentationId::rpy, codec_for<EulerRow>()},
    {RepresentationId::cayley, codec_for<CayleyRow>()},
    {RepresentationId::mrp, codec_for<MrpRow>()},
});
static_assert(is_indexed(codecs, representation_count, &NamedCodec::name));

} // namespace

const Codec& codec_of(RepresentationId name) noexcept { return codecs[static_cast<std::size_t>(name)].codec; }

} // namespace rotconv
