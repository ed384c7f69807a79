#include <rotconv/axes.hpp>

#include <algorithm>
#include <array>

#include "text.hpp"

namespace rotconv {
namespace {

/// The letters for x, -x, y, -y, z, -z of right-handed axes, in each set.
constexpr std::array<std::string_view, 3> sets{"ewnsud", "fblrud", "xXyYzZ"};

/// A letter for each direction of a triple, in lower case; X for -x.
std::string letters_of(std::string_view triple) {
    std::string letters;
    for (const char c : lower(triple)) {
        if (letters.ends_with('-')) {
            letters.back() = c >= 'x' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : '?';
        } else {
            letters += c;
        }
    }
    return letters;
}

} // namespace

FixedRotation AxesChange::rotation() const noexcept {
    const Dcm rotation = matrix * (changes_hand() ? -1.0 : 1.0);
    return FixedRotation::of_numbers(eigen_matrix, {rotation.data(), 9});
}

std::string message(const AxesError& error) {
    using What = AxesError::What;
    const std::string letters = "n s e w u d, f b l r u d, or x y z, with - if against them";
    const std::string text = "'" + error.text + "'";
    const std::string triple = text + ": '" + error.triple + "'";
    switch (error.what) {
    case What::form:
        return text + " is not FROM:TO, such as ned:enu: where x, y and z point, in three letters of " + letters;
    case What::mixed_sets: return text + ": the letters must be of one set: " + letters;
    case What::same_direction: return triple + " has one direction twice";
    case What::opposite_directions: return triple + " has opposite directions, but x, y and z are perpendicular";
    }
    return {};
}

std::variant<AxesChange, AxesError> parse_axes(std::string_view text) {
    using What = AxesError::What;
    const auto colon = std::min(text.find(':'), text.size());
    const std::array<std::string_view, 2> triples{text.substr(0, colon), text.substr(std::min(colon + 1, text.size()))};
    const std::array<std::string, 2> letters{letters_of(triples[0]), letters_of(triples[1])};
    const std::string all = letters[0] + letters[1];
    if (letters[0].size() != 3 || letters[1].size() != 3 ||
        all.find_first_not_of("nsewudfblrxXyYzZ") != std::string::npos) {
        return AxesError{What::form, std::string(text)};
    }
    const auto* const set = std::ranges::find(sets, std::string::npos,
                                              [&](std::string_view legal) { return all.find_first_not_of(legal); });
    if (set == sets.end()) {
        return AxesError{What::mixed_sets, std::string(text)};
    }
    std::array<Dcm, 2> axes; // row by row x, y and z in the set's axes
    for (std::size_t t = 0; t < 2; ++t) {
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<int>(set->find(letters.at(t)[static_cast<std::size_t>(i)]));
            axes.at(t).row(i) = Eigen::RowVector3d::Unit(at / 2) * (at % 2 == 0 ? 1.0 : -1.0);
            for (int j = 0; j < i; ++j) {
                const double along = axes.at(t).row(i).dot(axes.at(t).row(j));
                if (along != 0.0) {
                    return AxesError{along > 0.0 ? What::same_direction : What::opposite_directions, std::string(text),
                                     std::string(triples.at(t))};
                }
            }
        }
    }
    return AxesChange{axes[1] * axes[0].transpose(), axes[0].determinant() < 0.0, axes[1].determinant() < 0.0};
}

std::string axes_text(const Rotation& change) {
    const Dcm matrix = dcm::from_rotation(change);
    if ((matrix.array() != matrix.array().round()).any()) {
        return {};
    }
    std::string text = "xyz:"; // where each of the new axes points, in the old ones
    for (Eigen::Index i = 0; i < 9; ++i) {
        const double entry = matrix(i / 3, i % 3);
        text += entry < 0.0 ? "-" : "";
        text += entry != 0.0 ? std::string(1, static_cast<char>('x' + i % 3)) : "";
    }
    return text;
}

} // namespace rotconv
