#include "comparison_model.hpp"

#include <algorithm>
#include <cmath>

#include "oracle.hpp"

namespace fuzz {
namespace {

using rotconv::RepresentationId;
using rotconv::Spec;
using Numbers = std::span<const double>;

bool is_finite(Numbers numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool is_matrix(const Spec& spec) {
    return spec.name == RepresentationId::dcm || spec.name == RepresentationId::two_column ||
           spec.name == RepresentationId::five_d;
}

/// Whether the numbers have no attitude; nothing where that is not known.
std::optional<bool> refuses(const Spec& spec, Numbers numbers, double tolerance) {
    if (!is_finite(numbers)) {
        return true;
    }
    if (is_matrix(spec)) {
        return std::nullopt;
    }
    long double square = 0.0L;
    for (const double number : numbers.first(std::min<std::size_t>(numbers.size(), 4))) {
        square += static_cast<long double>(number) * static_cast<long double>(number);
    }
    if (spec.name == RepresentationId::quat) {
        const long double defect = std::fabs(std::sqrt(square) - 1.0L);
        if (square > 0.0L && std::fabs(defect - tolerance) <= 1e-12L * (1.0L + std::min(1.0, tolerance))) {
            return std::nullopt;
        }
        return square == 0.0L || defect > tolerance;
    }
    const bool no_axis = std::ranges::all_of(numbers.first(3), [](double number) { return number == 0.0; });
    return spec.name == RepresentationId::axis_angle && no_axis && numbers[3] != 0.0;
}

/// Neither is a matrix all but singular, nor has an angle many turns.
bool is_well_conditioned(const Spec& spec, Numbers numbers, double tolerance) {
    constexpr double largest_angle = 1e6;
    const bool has_angles = rotconv::representation(spec.name).has_angles();
    const bool is_axis = spec.name == RepresentationId::axis_angle; // of any length
    return has_angles ? std::ranges::all_of(numbers.subspan(is_axis ? 3 : 0),
                                            [](double number) { return std::fabs(number) <= largest_angle; })
                      : !is_matrix(spec) || tolerance <= 1e-3;
}

bool is_well_conditioned(const Compared& compared, Numbers numbers) {
    const std::size_t size = compared.from.size();
    return is_finite(numbers) && is_well_conditioned(compared.from, numbers.first(size), compared.tolerance) &&
           is_well_conditioned(compared.reference, numbers.subspan(size), compared.tolerance);
}

bool is_same(const Spec& a, const Spec& b) {
    return a.name == b.name && a.order() == b.order() && a.unit == b.unit && a.passive == b.passive &&
           a.sequence == b.sequence;
}

} // namespace

Agreement check_refusal(const Compared& compared, Numbers numbers, bool refused, bool of_reference) {
    const auto first = refuses(compared.from, numbers.first(compared.from.size()), compared.tolerance);
    const auto second = refuses(compared.reference, numbers.subspan(compared.from.size()), compared.tolerance);
    if (!first || (!*first && !second)) {
        return Agreement::not_modelled;
    }
    const bool is_right = refused == (*first || *second) && (!refused || of_reference == !*first);
    return is_right ? Agreement::yes : Agreement::no;
}

Agreement check_angle(const Compared& compared, Numbers numbers, double angle) {
    if (compared.is_turned) {
        return Agreement::not_modelled;
    }
    const Numbers first = numbers.first(compared.from.size());
    const Numbers second = numbers.subspan(compared.from.size());
    if (is_same(compared.from, compared.reference) && std::ranges::equal(first, second)) {
        return angle == 0.0 ? Agreement::yes : Agreement::no;
    }
    if (!is_well_conditioned(compared, numbers)) {
        return Agreement::not_modelled;
    }
    const double exact = oracle::eps * oracle::error_in_eps(oracle::attitude(compared.from, first),
                                                            oracle::attitude(compared.reference, second));
    const double unit = compared.degrees ? rotconv::degrees_per_radian : 1.0;
    return std::fabs(angle / unit - exact) <= 4.0 * oracle::eps ? Agreement::yes : Agreement::no;
}

Agreement check_relative(const Compared& compared, Numbers numbers, Numbers relative) {
    if (compared.is_turned || !is_well_conditioned(compared, numbers) ||
        !is_finite(relative)) { // the half-turn of cayley
        return Agreement::not_modelled;
    }
    const oracle::Quaternion a = oracle::attitude(compared.from, numbers.first(compared.from.size()));
    const oracle::Quaternion b = oracle::attitude(compared.reference, numbers.subspan(compared.from.size()));
    const oracle::Quaternion exact = compared.in_reference_axes ? a * b.conjugate() : b.conjugate() * a;
    const double error = oracle::eps * oracle::error_in_eps(oracle::attitude(*compared.relative, relative), exact);
    return error <= 16.0 * oracle::eps + compared.lock_margin ? Agreement::yes : Agreement::no;
}

} // namespace fuzz
