#include <rotconv/reading.hpp>

#include <array>

#include "enum_table.hpp"

namespace rotconv {

std::string_view name_of(Kind kind) noexcept {
    struct Line {
        Kind kind;
        std::string_view text;
    };
    static constexpr auto names = std::to_array<Line>({
        {Kind::normalized, "normalized"},
        {Kind::gimbal_lock, "gimbal-lock"},
        {Kind::near_gimbal_lock, "near-gimbal-lock"},
        {Kind::half_turn, "half-turn"},
        {Kind::infinite, "infinite"},
        {Kind::identity_axis, "identity-axis"},
        {Kind::method_error, "method-error"},
        {Kind::coarse_step, "coarse-step"},
    });
    static_assert(is_indexed(names, kind_count, &Line::kind));
    return names[static_cast<std::size_t>(kind)].text;
}

} // namespace rotconv
