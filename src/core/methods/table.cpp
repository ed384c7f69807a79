#include <rotconv/method.hpp>

#include <algorithm>
#include <array>

#include "figures.hpp"
#include "methods.hpp"

namespace rotconv {
namespace {

using formula::each_row;

constexpr Method own(Name from, Name to) noexcept {
    return {from, to, "default", "rotconv", "every input that describes an attitude", nullptr};
}

namespace dq = formula::dcm_to_quat;
namespace dr = formula::dcm_to_rotvec;
namespace dc = formula::dcm_to_cayley;
namespace qd = formula::quat_to_dcm;
namespace qr = formula::quat_to_rotvec;
namespace qe = formula::quat_to_euler;
namespace rd = formula::rotvec_to_dcm;
namespace cd = formula::cayley_to_dcm;

/// Each method with its figures.
template <std::size_t size> constexpr std::array<Method, size> measured(std::array<Method, size> methods) noexcept {
    for (Method& method : methods) {
        for (const Measurement& row : figures) {
            if (row.from == method.from && row.to == method.to && row.name == method.name) {
                method.clean = row.clean;
                method.hostile = row.hostile;
            }
        }
    }
    return methods;
}

// The rows of a pair stand together, its default first.
constexpr std::array table = measured(std::array{
    own(Name::dcm, Name::quat),
    Method{Name::dcm, Name::quat, "trace", "Baruh 1999, Eqs 1-4", "theta below 180 deg", each_row<9, 4, dq::trace>},
    Method{Name::dcm, Name::quat, "baruh", "Baruh 1999, Eqs 2-8", "theta below 180 deg", each_row<9, 4, dq::baruh>},
    Method{Name::dcm, Name::quat, "four-roots", "Chiaverini and Siciliano 1999",
           "theta below 180 deg, no component near 0", each_row<9, 4, dq::four_roots>},
    Method{Name::dcm, Name::quat, "klumpp", "Klumpp 1976, after its abstract", "no component near 0",
           each_row<9, 4, dq::klumpp>},
    Method{Name::dcm, Name::quat, "shepperd", "Shepperd 1978", "orthogonal matrices", each_row<9, 4, dq::shepperd>},
    Method{Name::dcm, Name::quat, "markley", "Markley 2008", "orthogonal matrices", each_row<9, 4, dq::markley>},
    Method{Name::dcm, Name::quat, "cayley", "Cayley's factorisation, in Sarabandi and Thomas 2019",
           "theta below 180 deg", each_row<9, 4, dq::cayley>},
    Method{Name::dcm, Name::quat, "sarabandi-thomas", "Sarabandi and Thomas 2018, eta = 0", "theta below 180 deg",
           each_row<9, 4, dq::sarabandi_thomas>},
    Method{Name::dcm, Name::quat, "bar-itzhack", "Bar-Itzhack 2000, version 3", "any proper matrix",
           each_row<9, 4, dq::bar_itzhack>},
    Method{Name::dcm, Name::quat, "svd", "Markley 1988, then Shepperd 1978", "any proper matrix",
           each_row<9, 4, dq::svd>},
    Method{Name::dcm, Name::quat, "polar", "Higham 1986, then Shepperd 1978", "any proper matrix, not near-singular",
           each_row<9, 4, dq::polar>},
    Method{Name::dcm, Name::quat, "compensated", "Davenport 1968, products after Dekker 1971",
           "near rotations, defect to 1e-8", each_row<9, 4, dq::compensated>},

    own(Name::dcm, Name::rotvec),
    Method{Name::dcm, Name::rotvec, "acos", "common property; Shuster 1993, Euler axis and angle",
           "theta away from 0 and 180 deg", each_row<9, 3, dr::acos>},
    Method{Name::dcm, Name::rotvec, "atan2", "common property, the angle by atan2", "theta above 0, below 180 deg",
           each_row<9, 3, dr::atan2>},
    Method{Name::dcm, Name::rotvec, "polynomial", "Stuelpnagel 1964, section 6, corrected",
           "theta away from 0 and 180 deg", each_row<9, 3, dr::polynomial>},
    Method{Name::dcm, Name::rotvec, "quaternion", "Shepperd 1978, then atan2", "orthogonal matrices but I",
           each_row<9, 3, dr::quaternion>},
    Method{Name::dcm, Name::rotvec, "compensated", "Davenport 1968, products after Dekker 1971",
           "near rotations, defect to 1e-8", each_row<9, 3, dr::compensated>},

    own(Name::dcm, Name::cayley),
    Method{Name::dcm, Name::cayley, "lu", "Stuelpnagel 1964, section 6", "theta below 180 deg", each_row<9, 3, dc::lu>},
    Method{Name::dcm, Name::cayley, "polynomial", "common property; Shuster 1993, Rodrigues vector",
           "theta below 180 deg", each_row<9, 3, dc::polynomial>},
    Method{Name::dcm, Name::cayley, "quaternion", "Shepperd 1978, then v/w", "orthogonal matrices",
           each_row<9, 3, dc::quaternion>},

    own(Name::quat, Name::dcm),
    Method{Name::quat, Name::dcm, "unit", "Stuelpnagel 1964, section 5", "unit quaternions", each_row<4, 9, qd::unit>},
    Method{Name::quat, Name::dcm, "two-over-norm", "Shoemake 1994, Eul_FromQuat", "norms from 1e-150 to 1e150",
           each_row<4, 9, qd::two_over_norm>},
    Method{Name::quat, Name::dcm, "homogeneous", "Baruh 1999, over the squared norm", "norms from 1e-150 to 1e150",
           each_row<4, 9, qd::homogeneous>},
    Method{Name::quat, Name::dcm, "normalise-first", "Stuelpnagel 1964, section 5, of q/|q|",
           "norms from 1e-150 to 1e150", each_row<4, 9, qd::normalise_first>},

    own(Name::quat, Name::rotvec),
    Method{Name::quat, Name::rotvec, "acos", "common property; Shuster 1993", "unit quaternions, theta away from 0",
           each_row<4, 3, qr::acos>},
    Method{Name::quat, Name::rotvec, "atan2", "Sola 2017, logarithmic map", "theta above 0", each_row<4, 3, qr::atan2>},
    Method{Name::quat, Name::rotvec, "compensated", "logarithm, products after Dekker 1971",
           "norms from 1e-150 to 1e150", each_row<4, 3, qr::compensated>},

    own(Name::quat, Name::euler),
    Method{Name::quat, Name::euler, "classic", "Diebel 2006, the twelve sequences", "unit quaternions away from lock",
           each_row<4, 3, qe::classic>},
    Method{Name::quat, Name::euler, "matrix-threshold", "Shoemake 1994, Eul_FromQuat, threshold 1.9e-6",
           "to 4e-6 rad near lock", each_row<4, 3, qe::matrix_threshold>},
    Method{Name::quat, Name::euler, "bernardes-arccos", "Bernardes and Viollet 2022, threshold 1e-7",
           "to 2e-7 rad near lock", each_row<4, 3, qe::bernardes_arccos>},
    Method{Name::quat, Name::euler, "bernardes-atan2", "Bernardes and Viollet 2022, atan2 for arccos",
           "any quaternion but 0", each_row<4, 3, qe::bernardes_atan2>},

    own(Name::rotvec, Name::dcm),
    Method{Name::rotvec, Name::dcm, "rodrigues", "Rodrigues 1840; Stuelpnagel 1964, section 6",
           "theta away from 0, moderate", each_row<3, 9, rd::rodrigues>},
    Method{Name::rotvec, Name::dcm, "half-angle", "Rodrigues 1840, 1 - cos by the half angle",
           "theta above 0, moderate", each_row<3, 9, rd::half_angle>},
    Method{Name::rotvec, Name::dcm, "quaternion", "Euler-Rodrigues parameters; Stuelpnagel 1964, section 5",
           "theta above 0, moderate", each_row<3, 9, rd::quaternion>},
    Method{Name::rotvec, Name::dcm, "compensated", "Euler-Rodrigues parameters, products after Dekker 1971",
           "lengths below 1e15", each_row<3, 9, rd::compensated>},

    own(Name::cayley, Name::dcm),
    Method{Name::cayley, Name::dcm, "inverse", "Stuelpnagel 1964, section 6", "lengths far below 1e16",
           each_row<3, 9, cd::inverse>},
    Method{Name::cayley, Name::dcm, "closed", "common property; Shuster 1993, Rodrigues vector", "lengths below 1e150",
           each_row<3, 9, cd::closed>},
});

constexpr Name set_of(Name name) noexcept { return name == Name::rpy ? Name::euler : name; }

} // namespace

bool Method::serves(Name source, Name target) const noexcept { return from == set_of(source) && to == set_of(target); }

std::span<const Method> methods() noexcept { return table; }

std::span<const Method> methods_of(Name from, Name to) noexcept {
    const auto of_pair = [from, to](const Method& method) { return method.serves(from, to); };
    const auto first = std::ranges::find_if(table, of_pair);
    const auto last = std::find_if_not(first, table.end(), of_pair);
    return {first, last};
}

const Method* find_method(Name from, Name to, std::string_view name) noexcept {
    const auto rows = methods_of(from, to);
    const auto found = std::ranges::find(rows, name, &Method::name);
    return found == rows.end() ? nullptr : &*found;
}

} // namespace rotconv
