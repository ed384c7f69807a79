#include "comparison_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <variant>
#include <vector>

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

/// "rpy:deg:0,90,30"; nothing if it is not that.
std::optional<oracle::Quaternion> attitude_of(const std::string& text, bool degrees) {
    const std::size_t colon = std::min(text.rfind(':'), text.size());
    const auto parsed = rotconv::parse_spec(text.substr(0, colon));
    const auto* const spec = std::get_if<Spec>(&parsed);
    std::vector<double> numbers;
    for (std::size_t at = colon; spec != nullptr && at < text.size();
         at = std::min(text.find(',', at + 1), text.size())) {
        numbers.push_back(std::strtod(text.c_str() + at + 1, nullptr));
    }
    return spec == nullptr || numbers.size() != spec->size()
               ? std::nullopt
               : std::optional(oracle::attitude(degrees ? spec->in_degrees() : *spec, numbers).normalized());
}

/// The matrix of "ned:enu", or its negative if it changes hand: the other side does too. Nothing where other words than
/// such triples stand there.
std::optional<oracle::Quaternion> axes_of(const std::string& text) {
    constexpr std::string_view directions = "fburlnsewd"; // of each letter one that is its opposite, or not
    constexpr std::string_view opposites = "bfdlrsnweu";
    if (text.size() != 7 || text[3] != ':') {
        return std::nullopt;
    }
    std::array<std::array<double, 3>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t letter = directions.find(text[4 + i]);
            if (letter == std::string_view::npos) {
                return std::nullopt;
            }
            m[i][k] = text[k] == text[4 + i] ? 1.0 : text[k] == opposites[letter] ? -1.0 : 0.0;
        }
    }
    const auto minor = [&m](std::size_t a, std::size_t b) { return m[1][a] * m[2][b] - m[1][b] * m[2][a]; };
    const double determinant = m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1);
    if (determinant == 0.0) {
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (const auto& row : m) {
        for (const double number : row) {
            numbers.push_back(determinant * number);
        }
    }
    return oracle::attitude(Spec{.name = RepresentationId::dcm}, numbers).normalized();
}

bool is_same(const Spec& a, const Spec& b) {
    return a.name == b.name && a.order() == b.order() && a.unit == b.unit && a.passive == b.passive &&
           a.sequence == b.sequence;
}

} // namespace

std::optional<Turns> turns_of(const std::string& left, const std::string& right, const std::string& reference_axes,
                              const std::string& body_axes, bool degrees) {
    const auto or_none = [](const std::string& text, auto of) {
        return text.empty() ? std::optional(oracle::Quaternion(oracle::Quaternion::Identity())) : of(text);
    };
    const auto l = or_none(left, [degrees](const auto& text) { return attitude_of(text, degrees); });
    const auto s = or_none(right, [degrees](const auto& text) { return attitude_of(text, degrees); });
    const auto m = or_none(reference_axes, axes_of);
    const auto n = or_none(body_axes, axes_of);
    if (!l || !s || !m || !n) {
        return std::nullopt;
    }
    return Turns{*l * *m, n->conjugate() * *s, !(left + right + reference_axes + body_axes).empty()};
}

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
    if (!compared.turns) {
        return Agreement::not_modelled;
    }
    const Numbers first = numbers.first(compared.from.size());
    const Numbers second = numbers.subspan(compared.from.size());
    const Turns& turns = *compared.turns;
    if (!turns.any && is_same(compared.from, compared.reference) && std::ranges::equal(first, second)) {
        return angle == 0.0 ? Agreement::yes : Agreement::no;
    }
    if (!is_well_conditioned(compared, numbers)) {
        return Agreement::not_modelled;
    }
    const double exact =
        oracle::eps * oracle::error_in_eps(turns.left * oracle::attitude(compared.from, first) * turns.right,
                                           oracle::attitude(compared.reference, second));
    return std::fabs(angle / compared.per_radian - exact) <= 4.0 * oracle::eps ? Agreement::yes : Agreement::no;
}

Agreement ComparedTurns::check_angle(const Compared& compared, Numbers numbers, double angle) {
    auto& now = pairs_.emplace_back();
    if (compared.turns && is_well_conditioned(compared, numbers)) {
        const std::size_t size = compared.from.size();
        now = {compared.turns->left * oracle::attitude(compared.from, numbers.first(size)) * compared.turns->right,
               oracle::attitude(compared.reference, numbers.subspan(size))};
    }
    if (pairs_.size() <= compared.delta) {
        return std::isnan(angle) ? Agreement::yes : Agreement::no;
    }
    const auto& before = pairs_[pairs_.size() - 1 - compared.delta];
    if (!now || !before) {
        return Agreement::not_modelled;
    }
    const auto turn = [&](std::size_t side) {
        return oracle::Quaternion(before->at(side).conjugate() * now->at(side)).normalized();
    };
    const double exact = oracle::eps * oracle::error_in_eps(turn(0), turn(1));
    return std::fabs(angle / compared.per_radian - exact) <= 32.0 * oracle::eps ? Agreement::yes : Agreement::no;
}

Agreement check_product(const Compared& compared, Numbers numbers, Numbers product) {
    if (!compared.turns || !is_well_conditioned(compared, numbers) || !is_finite(product)) { // the half-turn of cayley
        return Agreement::not_modelled;
    }
    const oracle::Quaternion a = compared.turns->left *
                                 oracle::attitude(compared.from, numbers.first(compared.from.size())) *
                                 compared.turns->right;
    const oracle::Quaternion b = oracle::attitude(compared.reference, numbers.subspan(compared.from.size()));
    const double error = oracle::eps * oracle::error_in_eps(oracle::attitude(*compared.product, product), a * b);
    return error <= 16.0 * oracle::eps + compared.lock_margin ? Agreement::yes : Agreement::no;
}

} // namespace fuzz
