#include <rotconv/axes.hpp>

#include <optional>
#include <string_view>

namespace rotconv {
namespace {

/// The letters of each set in the order of x, -x, y, -y, z, -z of right-handed axes. The last has signs instead.
constexpr std::array<std::string_view, 3> sets{"ewnsud", "fblrud", "x y z "};

/// Where each axis points: along one of three lines, with a sign.
struct Triple {
    std::string text{}; ///< in lower case
    std::array<std::size_t, 3> line{};
    std::array<double, 3> sign{};
    std::array<bool, sets.size()> may_be_of{true, true, true}; ///< the sets that have all its letters

    [[nodiscard]] bool left_handed() const noexcept {
        return ((line[1] + 3 - line[0]) % 3 == 1) != (sign[0] * sign[1] * sign[2] > 0.0);
    }
};

/// Nothing if the text is not three letters of the sets.
std::optional<Triple> read(std::string_view text) {
    Triple triple;
    std::size_t axis = 0;
    bool has_sign = false;
    double sign = 1.0;
    for (const char c : text) {
        const char letter = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        triple.text += letter;
        if (!has_sign && (letter == '-' || letter == '+')) {
            has_sign = true;
            sign = letter == '-' ? -1.0 : 1.0;
            continue;
        }
        bool known = false;
        for (std::size_t set = 0; set < sets.size(); ++set) {
            const std::size_t at = letter == ' ' ? std::string_view::npos : sets.at(set).find(letter);
            const bool has_letter = at != std::string_view::npos && (!has_sign || set + 1 == sets.size());
            triple.may_be_of.at(set) = triple.may_be_of.at(set) && has_letter;
            if (has_letter && axis < 3) {
                known = true;
                triple.line.at(axis) = at / 2;
                triple.sign.at(axis) = at % 2 == 0 ? sign : -1.0;
            }
        }
        if (!known) {
            return std::nullopt;
        }
        ++axis;
        has_sign = false;
        sign = 1.0;
    }
    return axis == 3 && !has_sign ? std::optional(triple) : std::nullopt;
}

/// Two of its axes on one line.
std::optional<AxesError> overlap(const Triple& triple) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
            if (triple.line.at(i) == triple.line.at(j)) {
                const bool same = triple.sign.at(i) == triple.sign.at(j);
                return AxesError{
                    same ? AxesError::What::same_direction : AxesError::What::opposite_directions, triple.text, {i, j}};
            }
        }
    }
    return std::nullopt;
}

} // namespace

FixedRotation AxesChange::turn() const noexcept {
    std::array<double, 9> rotation = matrix;
    for (double& entry : rotation) {
        entry = changes_hand() ? -entry : entry;
    }
    Spec dcm;
    dcm.name = RepresentationId::dcm;
    return FixedRotation::of_numbers(dcm, rotation);
}

std::variant<AxesChange, AxesError> parse_axes(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto from = read(text.substr(0, colon));
    const auto to = colon == std::string_view::npos ? std::nullopt : read(text.substr(colon + 1));
    if (!from || !to) {
        return AxesError{AxesError::What::form};
    }
    bool of_one_set = false;
    for (std::size_t set = 0; set < sets.size(); ++set) {
        of_one_set = of_one_set || (from->may_be_of.at(set) && to->may_be_of.at(set));
    }
    if (!of_one_set) {
        return AxesError{AxesError::What::mixed_sets};
    }
    for (const Triple& triple : {*from, *to}) {
        if (const auto error = overlap(triple)) {
            return *error;
        }
    }
    AxesChange change{.from_left_handed = from->left_handed(), .to_left_handed = to->left_handed()};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const bool along = to->line.at(i) == from->line.at(j);
            change.matrix.at(3 * i + j) = along ? to->sign.at(i) * from->sign.at(j) : 0.0;
        }
    }
    return change;
}

} // namespace rotconv
