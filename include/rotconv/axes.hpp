#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include <rotconv/conversion.hpp>
#include <rotconv/dcm.hpp>

namespace rotconv {

/// Other axes in the place of given ones, such as "ned:enu". Three letters say where x, y and z point.
struct AxesChange {
    Dcm matrix = Dcm::Identity(); ///< M, v_to = M v_from; its entries are 0, 1 and -1
    bool from_left_handed = false;
    bool to_left_handed = false;

    [[nodiscard]] bool changes_hand() const noexcept { return from_left_handed != to_left_handed; }
    /// M, or -M if M changes hand. With M of the reference axes and N of the body axes R becomes M R N', where both
    /// change hand or neither does: the product of three rotations in either case.
    [[nodiscard]] FixedRotation rotation() const noexcept;
};

/// Why a text does not name a change of axes.
struct AxesError {
    enum class What : std::uint8_t {
        form,                ///< not two triples of known letters with a colon between them
        mixed_sets,          ///< its letters are not of one set
        same_direction,      ///< two axes of `triple` point in one direction
        opposite_directions, ///< two axes of `triple` point in opposite directions
    };
    What what;
    std::string text; ///< all of it, as it was given
    std::string triple{};
};

/// The error in words, without a full stop.
[[nodiscard]] std::string message(const AxesError& error);

/// FROM:TO, in upper or lower case, of letters of one set: n s e w u d (north, ..., up, down), f b l r u d (forward,
/// back, left, right, ...), or x y z, each with a minus sign before it for the opposite direction. Where FROM is "xyz",
/// the letters of TO are FROM's own axes.
[[nodiscard]] std::variant<AxesChange, AxesError> parse_axes(std::string_view text);

/// A rotation that moves and negates axes alone as a change of axes, such as "xyz:yx-z"; empty for other rotations.
[[nodiscard]] std::string axes_text(const Rotation& change);

} // namespace rotconv
