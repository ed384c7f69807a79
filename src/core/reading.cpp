#include <rotconv/reading.hpp>

#include <array>
#include <stdexcept>

namespace rotconv {

void Reading::throw_no_rotation() { throw std::logic_error("rotconv: the numbers describe no rotation"); }

std::string_view name_of(DiagnosticKind kind) noexcept {
    static constexpr std::array<std::string_view, diagnostic_kind_count> names{
        "normalized",    "large-angle",  "gimbal-lock", "near-gimbal-lock", "half-turn", "infinite",
        "identity-axis", "method-error", "coarse-step", "beyond",           "few-digits"};
    static_assert(!names.back().empty());
    return names[static_cast<std::size_t>(kind)];
}

} // namespace rotconv
