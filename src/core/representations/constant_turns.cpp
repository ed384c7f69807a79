#include "constant_turns.hpp"

#include "../numerics/products.hpp"

namespace rotconv {
namespace {

/// a * b, each component rounded once: the plain product's four roundings would add 2 eps.
Rotation product(const Rotation& a, const Rotation& b) noexcept {
    const double w = sum_of_products(a.w(), b.w(), -a.x(), b.x(), -a.y(), b.y(), -a.z(), b.z());
    const double x = sum_of_products(a.w(), b.x(), a.x(), b.w(), a.y(), b.z(), -a.z(), b.y());
    const double y = sum_of_products(a.w(), b.y(), a.y(), b.w(), a.z(), b.x(), -a.x(), b.z());
    const double z = sum_of_products(a.w(), b.z(), a.z(), b.w(), a.x(), b.y(), -a.y(), b.x());
    const Rotation plain = Rotation::near_unit(w, x, y, z);
    const double square = plain.squared_norm();
    // A unit quaternion is not scaled, so that it is still unit where it is written.
    return square >= 0.25 && square < 4.0 ? plain : Rotation::from_components(w, x, y, z);
}

ExactQuaternion exact(const ConstantTurn& turn) noexcept {
    const Rotation& q = turn.rotation;
    return {{q.w(), q.x(), q.y(), q.z()}, {turn.rest[0], turn.rest[1], turn.rest[2], turn.rest[3]}};
}

std::optional<ConstantTurn> inverse_of(const std::optional<ConstantTurn>& turn) noexcept {
    return turn ? std::optional(turn->inverse()) : std::nullopt;
}

} // namespace

// (L R S)' = S' R' L'
ConstantTurns::ConstantTurns(const Settings& settings, bool passive) noexcept
    : left_(passive ? inverse_of(settings.right) : settings.left),
      right_(passive ? inverse_of(settings.left) : settings.right) {
    exact_left_ = left_ ? exact(*left_) : exact_left_;
    exact_right_ = right_ ? exact(*right_) : exact_right_;
}

void ConstantTurns::turn(Rotations& rotations, std::size_t rows) const noexcept {
    if (left_) {
        for (std::size_t i = 0; i < rows; ++i) {
            rotations.set(i, product(left_->rotation, rotations.at(i)));
        }
    }
    if (right_) {
        for (std::size_t i = 0; i < rows; ++i) {
            rotations.set(i, product(rotations.at(i), right_->rotation));
        }
    }
}

} // namespace rotconv
