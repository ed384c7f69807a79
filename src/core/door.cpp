#include "door.hpp"

#include <array>

#include <rotconv/axis_angle.hpp>
#include <rotconv/cayley.hpp>
#include <rotconv/columns.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/mrp.hpp>
#include <rotconv/quaternion.hpp>
#include <rotconv/rotation_vector.hpp>

#include "blocks.hpp"
#include "enum_table.hpp"

// Each struct below fits one room to rows of plain numbers: `read` and `write` of one row, around which `door_for`
// makes the loops, or `read_block` and `write_block`.

namespace rotconv {
namespace {

using Eigen::Map;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// A room whose numbers are one fixed-size matrix and know neither unit nor sequence.
template <class Numbers, auto ToRotation, auto FromRotation, auto FiguresOf> struct PlainRow {
    static constexpr std::size_t size = Numbers::SizeAtCompileTime;
    static Reading read(const Spec& /*spec*/, const double* v) noexcept { return ToRotation(Map<const Numbers>(v)); }
    // NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
    static void write(const Rotation& r, double* v) noexcept { Map<Numbers>{v} = FromRotation(r); }
    static Figures figures(const Spec& /*spec*/, const Rotation& r) noexcept { return FiguresOf(r); }
};

struct DcmRow : PlainRow<RowMajor, &dcm::to_rotation, &dcm::from_rotation, &dcm::figures> {
    static void read_block(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        dcm::read(numbers, rows, readings);
    }
    static double exact_defect(const double* v) noexcept { return dcm::defect(Map<const RowMajor>(v)); }
};

struct SixDRow : PlainRow<Columns, &columns::to_rotation, &columns::from_rotation, &columns::figures> {
    static void read_block(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        columns::read(numbers, rows, readings);
    }
    static double exact_defect(const double* v) noexcept { return columns::defect(Map<const Columns>(v)); }
};

struct FiveDRow : PlainRow<hopf::Vector5, &hopf::to_rotation, &hopf::from_rotation, &hopf::figures> {
    static void read_block(const Spec& /*spec*/, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        hopf::read(numbers, rows, readings);
    }
    static double exact_defect(const double* v) noexcept { return hopf::defect(Map<const hopf::Vector5>(v)); }
};

struct CayleyRow : PlainRow<Vector3d, &cayley::to_rotation, &cayley::from_rotation, &cayley::figures> {
    static void write_block(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, Notes* notes) noexcept {
        cayley::write(rotations, rows, numbers, notes);
    }
};

struct MrpRow : PlainRow<Vector3d, &mrp::to_rotation, &mrp::from_rotation, &mrp::figures> {
    static void write_block(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, Notes* notes) noexcept {
        mrp::write(rotations, rows, numbers, notes);
    }
};

struct QuatRow {
    static constexpr std::size_t size = 4;
    static Reading read(const Spec& /*spec*/, const double* v) noexcept {
        return quaternion::to_rotation({v[0], v[1], v[2], v[3]});
    }
    static double exact_defect(const double* v) noexcept { return quaternion::defect({v[0], v[1], v[2], v[3]}); }
    static void write_block(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, Notes* notes) noexcept {
        quaternion::write(rotations, rows, numbers, notes);
    }
    static Figures figures(const Spec& /*spec*/, const Rotation& r) noexcept { return quaternion::figures(r); }
};

struct AxisAngleRow {
    static constexpr std::size_t size = 4;
    static Reading read(const Spec& spec, const double* v) noexcept {
        return axis_angle::to_rotation({{v[0], v[1], v[2]}, v[3], spec.unit});
    }
    static void write_block(const Spec& spec, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, Notes* notes) noexcept {
        axis_angle::write(rotations, rows, spec.unit, numbers, notes);
    }
    static Figures figures(const Spec& /*spec*/, const Rotation& r) noexcept { return axis_angle::figures(r); }
};

struct RotvecRow {
    static void read_block(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
        rotation_vector::read(numbers, rows, spec.unit, readings);
    }
    static void write_block(const Spec& spec, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                            double* numbers, Notes* notes) noexcept {
        rotation_vector::write(rotations, rows, spec.unit, numbers, notes);
    }
    static Figures figures(const Spec& /*spec*/, const Rotation& r) noexcept { return rotation_vector::figures(r); }
};

struct EulerRow {
    static constexpr std::size_t size = 3;
    static Reading read(const Spec& spec, const double* v) noexcept {
        return euler::to_rotation({{v[0], v[1], v[2]}, spec.sequence, spec.unit});
    }
    static void write_block(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows,
                            double* numbers, Notes* notes) noexcept {
        euler::write(rotations, rows, spec.sequence, spec.unit, lock_margin, numbers, notes);
    }
    static Figures figures(const Spec& spec, const Rotation& r) noexcept { return euler::figures(r, spec.sequence); }
};

template <class Row> constexpr Door door_for() noexcept {
    Door door{};
    if constexpr (requires { &Row::read_block; }) {
        door.read = &Row::read_block;
    } else {
        door.read = [](const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
            for (std::size_t i = 0; i < rows; ++i) {
                readings.set(i, Row::read(spec, numbers + i * Row::size));
            }
        };
    }
    if constexpr (requires { &Row::write_block; }) {
        door.write = &Row::write_block;
    } else {
        door.write = [](const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows,
                        double* numbers, Notes* notes) noexcept {
            for (std::size_t i = 0; i < rows; ++i) {
                Row::write(rotations.at(i), numbers + i * Row::size);
                notes[i] = {};
            }
        };
    }
    door.figures = &Row::figures;
    if constexpr (requires { &Row::exact_defect; }) {
        door.exact_defect = &Row::exact_defect;
    }
    return door;
}

struct NamedDoor {
    Name name;
    Door door;
};
constexpr auto doors = std::to_array<NamedDoor>({
    {Name::dcm, door_for<DcmRow>()},
    {Name::six_d, door_for<SixDRow>()},
    {Name::five_d, door_for<FiveDRow>()},
    {Name::quat, door_for<QuatRow>()},
    {Name::axis_angle, door_for<AxisAngleRow>()},
    {Name::rotvec, door_for<RotvecRow>()},
    {Name::euler, door_for<EulerRow>()},
    {Name::rpy, door_for<EulerRow>()},
    {Name::cayley, door_for<CayleyRow>()},
    {Name::mrp, door_for<MrpRow>()},
});
static_assert(is_indexed(doors, name_count, &NamedDoor::name));

} // namespace

const Door& door_of(Name name) noexcept { return doors[static_cast<std::size_t>(name)].door; }

} // namespace rotconv
