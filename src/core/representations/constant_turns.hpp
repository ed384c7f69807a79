#pragma once

#include <cstddef>
#include <optional>

#include <rotconv/conversion.hpp>

#include "../batch.hpp"

namespace rotconv {

/// Settings::left and Settings::right, as they turn attitudes that are the inverse where `passive`.
class ConstantTurns {
public:
    ConstantTurns(const Settings& settings, bool passive) noexcept;

    [[nodiscard]] bool any() const noexcept { return left_ || right_; }
    /// Null where there is none.
    [[nodiscard]] const ExactQuaternion* left() const noexcept { return left_ ? &exact_left_ : nullptr; }
    [[nodiscard]] const ExactQuaternion* right() const noexcept { return right_ ? &exact_right_ : nullptr; }
    /// Each product is rounded once, which is 1 eps at most.
    void turn(Rotations& rotations, std::size_t rows) const noexcept;

private:
    std::optional<ConstantTurn> left_;
    std::optional<ConstantTurn> right_;
    ExactQuaternion exact_left_{};
    ExactQuaternion exact_right_{};
};

} // namespace rotconv
