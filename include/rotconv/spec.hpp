#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <rotconv/angle.hpp>
#include <rotconv/euler.hpp>
#include <rotconv/reading.hpp>

/// The table of representations, in the order in which they are listed, one row `line(identifier)` for each. Everything
/// else about a representation is in its codec and its kernel.
// clang-format off
#define ROTCONV_REPRESENTATIONS(line) \
    line(dcm) \
    line(two_column) \
    line(five_d) \
    line(quat) \
    line(axis_angle) \
    line(rotvec) \
    line(euler) \
    line(rpy) \
    line(cayley) \
    line(mrp)
// clang-format on

namespace rotconv {

#define ROTCONV_LINE(id) id,
/// Names a representation in code; representation() has the rest.
enum class RepresentationId : std::uint8_t { ROTCONV_REPRESENTATIONS(ROTCONV_LINE) };
#undef ROTCONV_LINE

#define ROTCONV_LINE(id) RepresentationId::id,
inline constexpr std::array all_representations{ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE

/// What changes how a representation's numbers are written down.
enum class Modifier : std::uint8_t { passive, deg, col, xyzw, wxyz, positive };
inline constexpr std::array all_modifiers{Modifier::passive, Modifier::deg,  Modifier::col,
                                          Modifier::xyzw,    Modifier::wxyz, Modifier::positive};

using ModifierSet = EnumSet<Modifier>;

struct Project;

/// What a preset stands for on one representation.
struct PresetMeaning {
    std::string_view preset{};
    ModifierSet modifiers{};
    std::optional<EulerSequence> sequence{}; ///< if the SPEC gives none
};

/// What a representation is called and how it is written.
struct Representation {
    RepresentationId name;
    std::string_view text;                     ///< as in a SPEC
    std::array<std::string_view, 3> aliases{}; ///< unused ones are empty
    std::size_t size;                          ///< number of numbers
    std::array<std::string_view, 9> columns;   ///< their names, in order
    ModifierSet modifiers;                     ///< those that have a meaning
    std::span<const PresetMeaning> presets{};  ///< those that have a meaning
    std::array<std::uint8_t, 9> other_order{}; ///< with col or xyzw: for each number as written, its own place
    bool takes_sequence = false;               ///< an Euler sequence follows the text
    bool has_gimbal_lock = false;              ///< Euler angles; the outer ones have the range (-pi, pi]
    bool has_half_turns = true;                ///< otherwise their numbers are infinite
    std::size_t first_angle = 0;               ///< the first of the numbers that is an angle, if there are angles
    bool angle_is_length = false;              ///< the length of the numbers is the one angle

    [[nodiscard]] bool has_angles() const noexcept { return modifiers.has(Modifier::deg); }
};

[[nodiscard]] const Representation& representation(RepresentationId name) noexcept;
/// The representation with this text or alias, in any case and with or without - and _, or null.
[[nodiscard]] const Representation* find_representation(std::string_view text) noexcept;
/// Empty if the preset leaves the representation unchanged.
[[nodiscard]] PresetMeaning meaning_of(std::string_view preset, const Representation& entry) noexcept;
[[nodiscard]] std::string_view name_of(Modifier modifier) noexcept;

/// A representation with its conventions resolved: the meaning of `NAME[:MODIFIER]...`. NAME may be a project's.
struct Spec {
    RepresentationId name = RepresentationId::quat;
    EulerSequence sequence = roll_pitch_yaw; ///< for euler and rpy
    AngleUnit unit = AngleUnit::radians;     ///< for angles
    bool passive = false;                    ///< the numbers describe the inverse
    bool column_major = false;               ///< dcm listed column by column
    bool scalar_last = false;                ///< quat as x y z w
    bool positive = false;                   ///< outer Euler angles are written in [0, 2 pi)
    const Project* project = nullptr;        ///< the one whose name, or preset, the SPEC has
    bool has_own_columns = false;            ///< the numbers have the project's names
    bool has_given_order = false;            ///< xyzw, wxyz or col is one of the modifiers, of no preset

    [[nodiscard]] std::size_t size() const noexcept { return representation(name).size; }
    /// The modifiers; wxyz, which changes nothing, is not one of them.
    [[nodiscard]] ModifierSet modifiers() const noexcept;
    void apply(const ModifierSet& modifiers) noexcept;
    /// For each number as written, its place in the representation's own order; size() entries count.
    [[nodiscard]] std::array<std::uint8_t, 9> order() const noexcept;
    /// Whether order() is not 0, 1, 2...
    [[nodiscard]] bool is_reordered() const noexcept { return column_major || scalar_last; }
    /// The column names in the order in which the numbers are written.
    [[nodiscard]] std::array<std::string_view, 9> columns() const noexcept;
    /// The name and the modifiers, which parse_spec() reads.
    [[nodiscard]] std::string text() const;
    /// The same with angles, if the representation has any, in degrees.
    [[nodiscard]] Spec in_degrees() const noexcept;
};

/// The text().
std::ostream& operator<<(std::ostream& out, const Spec& spec);

/// The order in which Eigen stores the entries of a matrix, and the components of a quaternion: those of data().
inline constexpr Spec eigen_matrix{.name = RepresentationId::dcm, .column_major = true};
inline constexpr Spec eigen_quaternion{.name = RepresentationId::quat, .scalar_last = true};

/// Why a text is not a SPEC.
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
    std::string text;                   ///< the part that is wrong, as it was given
    const Representation* in = nullptr; ///< the representation that the text names, if any
};

/// The error in words, without a full stop.
[[nodiscard]] std::string message(const SpecError& error);

/// Reads `NAME[:MODIFIER]...`, names and modifiers in any case and with or without - and _. The sequence, whose case
/// counts, follows `euler`, as in euler:ZYX; three digits may be joined to it, as in euler321.
[[nodiscard]] std::variant<Spec, SpecError> parse_spec(std::string_view text);

} // namespace rotconv
