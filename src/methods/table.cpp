#include "method.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "formulas.hpp"

namespace rotconv {
namespace {

using enum RepresentationId;

constexpr std::size_t size_of(RepresentationId name) noexcept {
    return name == dcm ? 9 : name == two_column ? 6 : name == quat ? 4 : 3;
}

/// A formula for one row, which takes the Euler sequence first where it needs it.
template <auto formula> void apply([[maybe_unused]] EulerSequence sequence, const double* in, double* out) noexcept {
    if constexpr (std::is_invocable_v<decltype(formula), EulerSequence, const double*, double*>) {
        formula(sequence, in, out);
    } else {
        formula(in, out);
    }
}

/// A formula of two, by way of another representation.
template <RepresentationId middle, formula::Formula* first, auto second>
void by_way_of(EulerSequence sequence, const double* in, double* out) noexcept {
    std::array<double, size_of(middle)> numbers;
    first(in, numbers.data());
    apply<second>(sequence, numbers.data(), out);
}

template <RepresentationId from, RepresentationId to, auto one_row>
constexpr Method row(std::string_view name, std::string_view reference, std::string_view domain) noexcept {
    const auto each_row = [](EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
        for (std::size_t i = 0; i < rows; ++i, in += size_of(from), out += size_of(to)) {
            apply<one_row>(sequence, in, out);
        }
    };
    return {from, to, name, reference, domain, each_row};
}

namespace dq = formula::dcm_to_quat;
namespace dr = formula::dcm_to_rotvec;
namespace de = formula::dcm_to_euler;
namespace dc = formula::dcm_to_cayley;
namespace qd = formula::quat_to_dcm;
namespace qr = formula::quat_to_rotvec;
namespace qe = formula::quat_to_euler;
namespace rq = formula::rotvec_to_quat;
namespace rd = formula::rotvec_to_dcm;
namespace cd = formula::cayley_to_dcm;
namespace td = formula::two_column_to_dcm;

// The rows of a pair stand together.
constexpr std::array table{
    row<dcm, quat, dq::trace>("trace", "Baruh 1999, Eqs 1-4", "theta below 180 deg"),
    row<dcm, quat, dq::baruh>("baruh", "Baruh 1999, Eqs 2-8", "theta below 180 deg"),
    row<dcm, quat, dq::four_roots>("four-roots", "Chiaverini and Siciliano 1999",
                                   "theta below 180 deg, no component near 0"),
    row<dcm, quat, dq::klumpp>("klumpp", "Klumpp 1976, after its abstract", "no component near 0"),
    row<dcm, quat, dq::shepperd>("shepperd", "Shepperd 1978", "orthogonal matrices"),
    row<dcm, quat, dq::markley>("markley", "Markley 2008", "orthogonal matrices"),
    row<dcm, quat, dq::first_order>("first-order", "Bjorck, Bowie 1971, then Markley 2008", "defect to 1e-8"),
    row<dcm, quat, dq::cayley>("cayley", "Cayley, in Sarabandi and Thomas 2019", "theta below 180 deg"),
    row<dcm, quat, dq::sarabandi_thomas>("sarabandi-thomas", "Sarabandi and Thomas 2018, eta = 0",
                                         "theta below 180 deg"),
    row<dcm, quat, dq::sarabandi_2020>("sarabandi-2020", "Sarabandi et al. 2020, approximate", "orthogonal matrices"),
    row<dcm, quat, dq::adjugate>("adjugate", "Hanson, Hanson 2022, without noise", "orthogonal matrices"),
    row<dcm, quat, dq::bar_itzhack>("bar-itzhack", "Bar-Itzhack 2000, version 3", "any proper matrix"),
    row<dcm, quat, dq::svd>("svd", "Markley 1988, then Shepperd 1978", "any proper matrix"),
    row<dcm, quat, dq::polar>("polar", "Higham 1986, then Shepperd 1978", "any proper matrix, not near-singular"),
    row<dcm, quat, dq::compensated>("compensated", "Davenport 1968, with Dekker 1971",
                                    "near rotations, defect to 1e-8"),

    row<dcm, rotvec, dr::acos>("acos", "Shuster 1993, Euler axis and angle", "theta away from 0 and 180 deg"),
    row<dcm, rotvec, dr::atan2>("atan2", "common property, the angle by atan2", "theta above 0, below 180 deg"),
    row<dcm, rotvec, dr::polynomial>("polynomial", "Stuelpnagel 1964, section 6, corrected",
                                     "theta away from 0 and 180 deg"),
    row<dcm, rotvec, dr::nurlanov>("nurlanov", "Nurlanov 2021, Eqs 8, 9b, 12, 13",
                                   "theta away from 180 deg, no component near 0"),
    row<dcm, rotvec, dr::gtsam>("gtsam", "GTSAM 4.2, SO3::Logmap", "theta away from 0 and 180 deg"),
    row<dcm, rotvec, dr::hertzberg>("hertzberg", "GTSAM 2026; Hertzberg et al. 2013", "orthogonal matrices"),
    row<dcm, rotvec, dr::quaternion>("quaternion", "Shepperd 1978, then Sola 2017", "orthogonal matrices"),
    row<dcm, rotvec, by_way_of<quat, dq::compensated, qr::compensated>>(
        "compensated", "Davenport 1968, with Dekker 1971", "near rotations, defect to 1e-8"),

    row<dcm, euler, de::asin>("asin", "Diebel 2006, the twelve sequences", "orthogonal, away from lock"),
    row<dcm, euler, de::slabaugh>("slabaugh", "Slabaugh 1999, for all sequences", "orthogonal, away from lock"),
    row<dcm, euler, de::shoemake>("shoemake", "Shoemake 1994, threshold 1.9e-6", "orthogonal, to 4e-6 rad near lock"),
    row<dcm, euler, de::shuster_markley>("shuster-markley", "Shuster, Markley 2006, limit 1e-7",
                                         "orthogonal, to 2e-7 rad near lock"),
    row<dcm, euler, de::eigen>("eigen", "Eigen 3.4, eulerAngles", "orthogonal matrices"),

    row<dcm, cayley, dc::lu>("lu", "Stuelpnagel 1964, section 6", "theta below 180 deg"),
    row<dcm, cayley, dc::polynomial>("polynomial", "Shuster 1993, Rodrigues vector", "theta below 180 deg"),
    row<dcm, cayley, dc::quaternion>("quaternion", "Shepperd 1978, then v/w", "orthogonal matrices"),

    row<quat, dcm, qd::unit>("unit", "Stuelpnagel 1964, section 5", "unit quaternions"),
    row<quat, dcm, qd::two_over_norm>("two-over-norm", "Shoemake 1994, Eul_FromQuat", "norms from 1e-150 to 1e150"),
    row<quat, dcm, qd::homogeneous>("homogeneous", "Baruh 1999, over the squared norm", "norms from 1e-150 to 1e150"),
    row<quat, dcm, qd::normalise_first>("normalise-first", "Stuelpnagel 1964, section 5, of q/|q|",
                                        "norms from 1e-150 to 1e150"),

    row<quat, rotvec, qr::acos>("acos", "Shuster 1993", "unit quaternions, theta away from 0"),
    row<quat, rotvec, qr::atan2>("atan2", "Sola 2017, logarithmic map", "norms from 1e-150 to 1e150"),
    row<quat, rotvec, qr::compensated>("compensated", "logarithm, products after Dekker 1971",
                                       "norms from 1e-150 to 1e150"),

    row<quat, euler, by_way_of<dcm, qd::unit, de::asin>>("classic", "Diebel 2006, the twelve sequences",
                                                         "unit quaternions away from lock"),
    row<quat, euler, by_way_of<dcm, qd::two_over_norm, de::shoemake>>(
        "matrix-threshold", "Shoemake 1994, threshold 1.9e-6", "to 4e-6 rad near lock"),
    row<quat, euler, qe::bernardes_arccos>("bernardes-arccos", "Bernardes, Viollet 2022, limit 1e-7",
                                           "to 2e-7 rad near lock"),
    row<quat, euler, qe::bernardes_atan2>("bernardes-atan2", "Bernardes, Viollet 2022, by atan2",
                                          "any quaternion but 0"),

    row<rotvec, quat, rq::half_angle>("half-angle", "Rodrigues 1840, by the half angle", "theta above 0, moderate"),
    row<rotvec, quat, rq::taylor>("taylor", "the same, series to 1e-3 as in SciPy", "theta moderate"),
    row<rotvec, quat, rq::branchless>("branchless", "the same, 2^-1022 added to theta", "theta moderate"),

    row<rotvec, dcm, rd::rodrigues>("rodrigues", "Rodrigues 1840; Stuelpnagel 1964", "theta away from 0, moderate"),
    row<rotvec, dcm, rd::half_angle>("half-angle", "Rodrigues 1840, by the half angle", "theta above 0, moderate"),
    row<rotvec, dcm, by_way_of<quat, rq::half_angle, qd::unit>>("quaternion", "Stuelpnagel 1964, section 5",
                                                                "theta above 0, moderate"),
    row<rotvec, dcm, rd::compensated>("compensated", "Stuelpnagel 1964, with Dekker 1971", "lengths below 1e15"),

    row<cayley, dcm, cd::inverse>("inverse", "Stuelpnagel 1964, section 6", "lengths far below 1e16"),
    row<cayley, dcm, cd::closed>("closed", "Shuster 1993, Rodrigues vector", "lengths below 1e150"),

    row<two_column, dcm, td::gram_schmidt>("gram-schmidt", "Zhou et al. 2019", "lengths from 1e-150 to 1e150"),
    row<two_column, dcm, td::symmetric>("symmetric", "Loewdin 1950, of two columns", "columns at right angles"),
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
