#include <rotconv/reading.hpp>

#include <array>
#include <stdexcept>

namespace rotconv {

void Reading::throw_no_rotation() { throw std::logic_error("rotconv: the numbers describe no rotation"); }

std::string_view message(Error error) noexcept {
    switch (error) {
    case Error::none: return "no error";
    case Error::not_finite: return "not finite";
    case Error::overflow: return "the result is too large for a double";
    case Error::zero_quaternion: return "a zero quaternion has no attitude";
    case Error::zero_axis: return "a zero axis with an angle that is not 0";
    case Error::not_proper: return "no rotation is nearest to a matrix with det <= 0";
    case Error::rank_deficient: return "the columns do not span a plane";
    case Error::defect: return "the defect is above the tolerance";
    case Error::singular: return "no rates at this attitude, or a step came too near to a singular one";
    case Error::coarse_step: return "the body may turn by more in one step than the representation can follow";
    case Error::time_order: return "time does not increase";
    case Error::past_half_turn: return "the body may have turned by half a turn or more since the row before (a gap?)";
    case Error::ended: return "no attitude, because an earlier row failed";
    }
    return {};
}

std::string_view name_of(DiagnosticKind kind) noexcept {
    static constexpr std::array<std::string_view, diagnostic_kind_count> names{
        "normalized",    "normalized",   "large-angle", "gimbal-lock", "near-gimbal-lock", "half-turn", "infinite",
        "identity-axis", "method-error", "coarse-step", "beyond"};
    static_assert(!names.back().empty());
    return names[static_cast<std::size_t>(kind)];
}

} // namespace rotconv
