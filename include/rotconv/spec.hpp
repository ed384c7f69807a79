#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <rotconv/angle.hpp>
#include <rotconv/euler.hpp>

namespace rotconv {

/// The representations, in the order in which they are listed.
enum class RepresentationId : std::uint8_t {
    dcm,
    two_column,
    five_d,
    quat,
    axis_angle,
    rotvec,
    euler,
    rpy,
    cayley,
    mrp
};
inline constexpr std::size_t representation_count = static_cast<std::size_t>(RepresentationId::mrp) + 1;

/// What changes how a representation's numbers are written down.
enum class Modifier : std::uint8_t { passive, deg, col, xyzw };
inline constexpr std::array all_modifiers{Modifier::passive, Modifier::deg, Modifier::col, Modifier::xyzw};

/// One line of the table of representations.
struct Representation {
    RepresentationId name;
    std::string_view text;                        ///< as in a SPEC
    std::array<std::string_view, 2> aliases;      ///< unused ones are empty
    std::size_t size;                             ///< how many numbers
    std::array<std::string_view, 9> columns;      ///< their names, in order
    std::array<bool, all_modifiers.size()> takes; ///< which modifiers have a meaning, by Modifier

    [[nodiscard]] bool accepts(Modifier modifier) const noexcept { return takes[static_cast<std::size_t>(modifier)]; }
    [[nodiscard]] bool has_angles() const noexcept { return accepts(Modifier::deg); }
};

/// A named set of conventions: which modifiers it stands for on which representations.
struct Preset {
    std::string_view text;
    std::array<RepresentationId, 8> passive_on; ///< the representations that it makes passive...
    std::size_t passive_count;                  ///< ...and how many of them there are
    bool scalar_last;                           ///< quat:xyzw

    [[nodiscard]] std::span<const RepresentationId> passive() const noexcept {
        return {passive_on.data(), passive_count};
    }
};

[[nodiscard]] std::span<const Representation> representations() noexcept;
[[nodiscard]] std::span<const Preset> presets() noexcept;
[[nodiscard]] const Representation& representation(RepresentationId name) noexcept;
[[nodiscard]] std::string_view name_of(Modifier modifier) noexcept;

/// A representation with its conventions resolved: what `NAME[:MODIFIER]...` means.
struct Spec {
    RepresentationId name = RepresentationId::quat;
    EulerSequence sequence = roll_pitch_yaw; ///< of euler and rpy
    AngleUnit unit = AngleUnit::radians;     ///< of representations that have angles
    bool passive = false;                    ///< the numbers describe the inverse
    bool column_major = false;               ///< dcm listed column by column
    bool scalar_last = false;                ///< quat as x y z w

    [[nodiscard]] std::size_t size() const noexcept { return representation(name).size; }
    /// For each number as written, its place in the representation's own order; size() entries count.
    [[nodiscard]] std::array<std::uint8_t, 9> order() const noexcept;
    /// The column names in the order in which the numbers are written.
    [[nodiscard]] std::array<std::string_view, 9> columns() const noexcept;
    /// Angles in degrees, where the representation has any.
    [[nodiscard]] Spec in_degrees() const noexcept;
};

/// Why a text is no SPEC.
struct SpecError {
    enum class What : std::uint8_t {
        unknown_name,
        no_sequence,
        unknown_sequence,
        unknown_modifier,
        meaningless_modifier,
        second_preset
    };
    What what;
    std::string text;                   ///< the part at fault
    const Representation* in = nullptr; ///< the representation it was given to, where known
};

/// Reads `NAME[:MODIFIER]...`, case-sensitive; `euler` is followed by its sequence.
[[nodiscard]] std::variant<Spec, SpecError> parse_spec(std::string_view text);

} // namespace rotconv
