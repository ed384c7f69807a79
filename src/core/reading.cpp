#include <rotconv/reading.hpp>

#include <array>

namespace rotconv {

std::string_view name_of(Kind kind) noexcept {
    static constexpr std::array<std::string_view, kind_count> names{
        "normalized", "gimbal-lock", "near-gimbal-lock", "half-turn", "infinite", "identity-axis", "method-error"};
    return names[static_cast<std::size_t>(kind)];
}

} // namespace rotconv
