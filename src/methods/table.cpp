#include "method.hpp"

#include <algorithm>
#include <array>

#include "formulas.hpp"

namespace rotconv {
namespace {

using formula::each_row;

constexpr Method own(RepresentationId from, RepresentationId to) noexcept {
    return {from, to, default_method, own_reference, every_input, nullptr};
}

using enum RepresentationId;
namespace dq = formula::dcm_to_quat;
namespace dr = formula::dcm_to_rotvec;
namespace dc = formula::dcm_to_cayley;
namespace qd = formula::quat_to_dcm;
namespace qr = formula::quat_to_rotvec;
namespace qe = formula::quat_to_euler;
namespace rd = formula::rotvec_to_dcm;
namespace cd = formula::cayley_to_dcm;

// The rows of a pair stand together, its default first.
constexpr std::array table{
    own(dcm, quat),
    Method{dcm, quat, "trace", "Baruh 1999, Eqs 1-4", "theta below 180 deg", each_row<9, 4, dq::trace>},
    Method{dcm, quat, "baruh", "Baruh 1999, Eqs 2-8", "theta below 180 deg", each_row<9, 4, dq::baruh>},
    Method{dcm, quat, "four-roots", "Chiaverini and Siciliano 1999", "theta below 180 deg, no component near 0",
           each_row<9, 4, dq::four_roots>},
    Method{dcm, quat, "klumpp", "Klumpp 1976, after its abstract", "no component near 0", each_row<9, 4, dq::klumpp>},
    Method{dcm, quat, "shepperd", "Shepperd 1978", "orthogonal matrices", each_row<9, 4, dq::shepperd>},
    Method{dcm, quat, "markley", "Markley 2008", "orthogonal matrices", each_row<9, 4, dq::markley>},
    Method{dcm, quat, "cayley", "Cayley, in Sarabandi and Thomas 2019", "theta below 180 deg",
           each_row<9, 4, dq::cayley>},
    Method{dcm, quat, "sarabandi-thomas", "Sarabandi and Thomas 2018, eta = 0", "theta below 180 deg",
           each_row<9, 4, dq::sarabandi_thomas>},
    Method{dcm, quat, "bar-itzhack", "Bar-Itzhack 2000, version 3", "any proper matrix",
           each_row<9, 4, dq::bar_itzhack>},
    Method{dcm, quat, "svd", "Markley 1988, then Shepperd 1978", "any proper matrix", each_row<9, 4, dq::svd>},
    Method{dcm, quat, "polar", "Higham 1986, then Shepperd 1978", "any proper matrix, not near-singular",
           each_row<9, 4, dq::polar>},
    Method{dcm, quat, "compensated", "Davenport 1968, with Dekker 1971", "near rotations, defect to 1e-8",
           each_row<9, 4, dq::compensated>},

    own(dcm, rotvec),
    Method{dcm, rotvec, "acos", "Shuster 1993, Euler axis and angle", "theta away from 0 and 180 deg",
           each_row<9, 3, dr::acos>},
    Method{dcm, rotvec, "atan2", "common property, the angle by atan2", "theta above 0, below 180 deg",
           each_row<9, 3, dr::atan2>},
    Method{dcm, rotvec, "polynomial", "Stuelpnagel 1964, section 6, corrected", "theta away from 0 and 180 deg",
           each_row<9, 3, dr::polynomial>},
    Method{dcm, rotvec, "quaternion", "Shepperd 1978, then Sola 2017", "orthogonal matrices",
           each_row<9, 3, dr::quaternion>},
    Method{dcm, rotvec, "compensated", "Davenport 1968, with Dekker 1971", "near rotations, defect to 1e-8",
           each_row<9, 3, dr::compensated>},

    own(dcm, cayley),
    Method{dcm, cayley, "lu", "Stuelpnagel 1964, section 6", "theta below 180 deg", each_row<9, 3, dc::lu>},
    Method{dcm, cayley, "polynomial", "Shuster 1993, Rodrigues vector", "theta below 180 deg",
           each_row<9, 3, dc::polynomial>},
    Method{dcm, cayley, "quaternion", "Shepperd 1978, then v/w", "orthogonal matrices", each_row<9, 3, dc::quaternion>},

    own(quat, dcm),
    Method{quat, dcm, "unit", "Stuelpnagel 1964, section 5", "unit quaternions", each_row<4, 9, qd::unit>},
    Method{quat, dcm, "two-over-norm", "Shoemake 1994, Eul_FromQuat", "norms from 1e-150 to 1e150",
           each_row<4, 9, qd::two_over_norm>},
    Method{quat, dcm, "homogeneous", "Baruh 1999, over the squared norm", "norms from 1e-150 to 1e150",
           each_row<4, 9, qd::homogeneous>},
    Method{quat, dcm, "normalise-first", "Stuelpnagel 1964, section 5, of q/|q|", "norms from 1e-150 to 1e150",
           each_row<4, 9, qd::normalise_first>},

    own(quat, rotvec),
    Method{quat, rotvec, "acos", "Shuster 1993", "unit quaternions, theta away from 0", each_row<4, 3, qr::acos>},
    Method{quat, rotvec, "atan2", "Sola 2017, logarithmic map", "norms from 1e-150 to 1e150",
           each_row<4, 3, qr::atan2>},
    Method{quat, rotvec, "compensated", "logarithm, products after Dekker 1971", "norms from 1e-150 to 1e150",
           each_row<4, 3, qr::compensated>},

    own(quat, euler),
    Method{quat, euler, "classic", "Diebel 2006, the twelve sequences", "unit quaternions away from lock",
           each_row<4, 3, qe::classic>},
    Method{quat, euler, "matrix-threshold", "Shoemake 1994, threshold 1.9e-6", "to 4e-6 rad near lock",
           each_row<4, 3, qe::matrix_threshold>},
    Method{quat, euler, "bernardes-arccos", "Bernardes, Viollet 2022, limit 1e-7", "to 2e-7 rad near lock",
           each_row<4, 3, qe::bernardes_arccos>},
    Method{quat, euler, "bernardes-atan2", "Bernardes, Viollet 2022, by atan2", "any quaternion but 0",
           each_row<4, 3, qe::bernardes_atan2>},

    own(rotvec, dcm),
    Method{rotvec, dcm, "rodrigues", "Rodrigues 1840; Stuelpnagel 1964", "theta away from 0, moderate",
           each_row<3, 9, rd::rodrigues>},
    Method{rotvec, dcm, "half-angle", "Rodrigues 1840, by the half angle", "theta above 0, moderate",
           each_row<3, 9, rd::half_angle>},
    Method{rotvec, dcm, "quaternion", "Stuelpnagel 1964, section 5", "theta above 0, moderate",
           each_row<3, 9, rd::quaternion>},
    Method{rotvec, dcm, "compensated", "Stuelpnagel 1964, with Dekker 1971", "lengths below 1e15",
           each_row<3, 9, rd::compensated>},

    own(cayley, dcm),
    Method{cayley, dcm, "inverse", "Stuelpnagel 1964, section 6", "lengths far below 1e16",
           each_row<3, 9, cd::inverse>},
    Method{cayley, dcm, "closed", "Shuster 1993, Rodrigues vector", "lengths below 1e150", each_row<3, 9, cd::closed>},
};

constexpr RepresentationId set_of(RepresentationId name) noexcept {
    return name == RepresentationId::rpy ? RepresentationId::euler : name;
}

} // namespace

bool Method::serves(RepresentationId source, RepresentationId target) const noexcept {
    return from == set_of(source) && to == set_of(target);
}

std::span<const Method> methods() noexcept { return table; }

std::span<const Method> methods_of(RepresentationId from, RepresentationId to) noexcept {
    const auto of_pair = [from, to](const Method& method) { return method.serves(from, to); };
    const auto* const first = std::ranges::find_if(table, of_pair);
    const auto* const last = std::find_if_not(first, table.end(), of_pair);
    return {first, last};
}

const Method* find_method(RepresentationId from, RepresentationId to, std::string_view name) noexcept {
    const auto rows = methods_of(from, to);
    const auto found = std::ranges::find(rows, name, &Method::name);
    return found == rows.end() ? nullptr : &*found;
}

} // namespace rotconv
