#include <rotconv/reading.hpp>

#include <array>
#include <stdexcept>

#include "enum_table.hpp"

namespace rotconv {

void Reading::throw_no_rotation() { throw std::logic_error("rotconv: the numbers describe no rotation"); }

std::string_view name_of(DiagnosticKind kind) noexcept {
    struct Line {
        DiagnosticKind kind;
        std::string_view text;
    };
    static constexpr auto names = std::to_array<Line>({
        {DiagnosticKind::normalized, "normalized"},
        {DiagnosticKind::gimbal_lock, "gimbal-lock"},
        {DiagnosticKind::near_gimbal_lock, "near-gimbal-lock"},
        {DiagnosticKind::half_turn, "half-turn"},
        {DiagnosticKind::infinite, "infinite"},
        {DiagnosticKind::identity_axis, "identity-axis"},
        {DiagnosticKind::method_error, "method-error"},
        {DiagnosticKind::coarse_step, "coarse-step"},
        {DiagnosticKind::beyond, "beyond"},
    });
    static_assert(is_indexed(names, diagnostic_kind_count, &Line::kind));
    return names[static_cast<std::size_t>(kind)].text;
}

} // namespace rotconv
