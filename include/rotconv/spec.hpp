#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <rotconv/angle.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/representation_id.hpp>

namespace rotconv {

/// What changes how a representation's numbers are written down.
enum class Modifier : std::uint8_t { passive, deg, col, xyzw, wxyz };
inline constexpr std::array all_modifiers{Modifier::passive, Modifier::deg, Modifier::col, Modifier::xyzw,
                                          Modifier::wxyz};

class ModifierSet {
public:
    constexpr ModifierSet(std::initializer_list<Modifier> modifiers) noexcept {
        for (const Modifier modifier : modifiers) {
            bits_ |= bit(modifier);
        }
    }
    [[nodiscard]] constexpr bool has(Modifier modifier) const noexcept { return (bits_ & bit(modifier)) != 0U; }

private:
    static constexpr unsigned bit(Modifier modifier) noexcept { return 1U << static_cast<unsigned>(modifier); }
    unsigned bits_ = 0;
};

/// A named set of conventions, such as those of a library. What it means for a representation stands with that.
struct Preset {
    std::string_view text;
    std::string_view about; ///< where it comes from, in a few words
};

/// The modifiers that a preset stands for on one representation.
struct PresetMeaning {
    std::string_view preset;
    ModifierSet modifiers;
};

/// What a representation is called and how it is written.
struct Representation {
    RepresentationId name;
    std::string_view text;                     ///< as in a SPEC
    std::array<std::string_view, 2> aliases{}; ///< unused ones are empty
    std::size_t size;                          ///< how many numbers
    std::array<std::string_view, 9> columns;   ///< their names, in order
    ModifierSet modifiers;                     ///< those that have a meaning
    std::span<const PresetMeaning> presets{};  ///< those that mean something, and what
    std::array<std::uint8_t, 9> other_order{}; ///< under col or xyzw: for each number as written, its own place
    bool takes_sequence = false;               ///< the text is followed by an Euler sequence
    bool has_gimbal_lock = false;              ///< Euler angles; the outer ones have the range (-pi, pi]
    std::string_view range;                    ///< of the numbers on output, for people
    std::string_view singular = "none";        ///< where it is singular, for people
    std::string_view singular_attitude{};      ///< where its equation is, such as "a half-turn"
    std::string_view formula;                  ///< for people

    [[nodiscard]] bool has_angles() const noexcept { return modifiers.has(Modifier::deg); }
};

[[nodiscard]] const Representation& representation(RepresentationId name) noexcept;
/// By its text or an alias; null where there is none.
[[nodiscard]] const Representation* find_representation(std::string_view text) noexcept;
[[nodiscard]] std::span<const Preset> presets() noexcept;
/// None where the preset leaves the representation as it is.
[[nodiscard]] ModifierSet modifiers_of(std::string_view preset, const Representation& entry) noexcept;
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
    /// Where that is not 0, 1, 2...
    [[nodiscard]] bool is_reordered() const noexcept { return column_major || scalar_last; }
    /// The column names in the order in which the numbers are written.
    [[nodiscard]] std::array<std::string_view, 9> columns() const noexcept;
    /// As parse_spec() reads it: the name and the modifiers.
    [[nodiscard]] std::string text() const;
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
        second_preset,
        two_orders ///< scalar first and last
    };
    What what;
    std::string text;                   ///< the part at fault
    const Representation* in = nullptr; ///< the representation it was given to, where known
};

/// Reads `NAME[:MODIFIER]...`, case-sensitive; `euler` is followed by its sequence.
[[nodiscard]] std::variant<Spec, SpecError> parse_spec(std::string_view text);

} // namespace rotconv
