#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include <rotconv/conversion.hpp>

namespace rotconv {

/// Other axes in the place of given ones, such as "ned:enu". Each triple of letters says where x, y and z point.
struct AxesChange {
    std::array<double, 9> matrix{}; ///< M, row by row: v_to = M v_from; its entries are 0, 1 and -1
    bool from_left_handed = false;
    bool to_left_handed = false;

    [[nodiscard]] bool changes_hand() const noexcept { return from_left_handed != to_left_handed; }
    /// M, or -M if M changes hand. With M of the reference axes and N of the body axes R becomes M R N'. Both change
    /// hand or neither does, so that this is the product of three rotations in either case.
    [[nodiscard]] FixedRotation turn() const noexcept;
};

/// Why a text names no change of axes.
struct AxesError {
    enum class What : std::uint8_t {
        form,                ///< not two triples of known letters with a colon between them
        mixed_sets,          ///< its letters are not of one set
        same_direction,      ///< two axes of `triple` point in one direction...
        opposite_directions, ///< ...or in opposite ones
    };
    What what;
    std::string triple{};
    std::array<std::size_t, 2> axes{}; ///< those two; 0, 1, 2 for x, y, z
};

/// FROM:TO, two triples of letters of one set: n s e w u d (north, ..., up, down), f b l r u d (forward, back, left,
/// right, ...), or x y z with signs, which are FROM's own axes where FROM is "xyz". Upper or lower case.
[[nodiscard]] std::variant<AxesChange, AxesError> parse_axes(std::string_view text);

} // namespace rotconv
