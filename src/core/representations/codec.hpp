#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "../conversion/kernels.hpp"

namespace rotconv {

/// Numbers whose range has an open end, and the other end, which means the same attitude.
struct OpenEnds {
    std::array<std::size_t, 2> numbers;
    double end;
    double other;
};

/// All that is known of a representation. Functions take numbers in the representation's own order and the attitude not
/// yet inverted: of a Spec's conventions the sequence and the unit are left to them.
struct Codec {
    Representation representation{};

    // For people.
    std::string_view range{};             ///< of the numbers on output
    std::string_view singular = "none";   ///< where the representation is singular
    std::string_view singular_attitude{}; ///< where its kinematic equation is, such as "a half-turn"
    std::string_view formula{};

    /// Another order in which programs list the numbers; with all 0 there is none.
    std::array<std::uint8_t, 9> listed_order{};
    bool has_any_length = false; ///< the numbers times a factor are as good

    /// The defect in full, where reading returns a bound only; null elsewhere.
    double (*exact_defect)(const double* numbers) noexcept = nullptr;
    Sensitivity (*sensitivity)(const Spec& spec, const Rotation& rotation) noexcept = nullptr;

    /// Null where all ranges are closed.
    OpenEnds (*open_ends)(const Spec& spec) noexcept = nullptr;

    /// Replaces the canonical numbers by those nearest to `last` among all that mean the attitude, or leaves them if
    /// they are as near. All are as they are written: what has a choice has no order of its own that
    /// would count. `rest` is what the exact canonical numbers have beside those written, a sum of doubles for each,
    /// and the diagnostics are theirs. False where it does not tell how a number rounds. Null where there are no
    /// others.
    bool (*choose_nearest)(const Spec& spec, const double* last, DiagnosticSet diagnostics,
                           std::span<const double> rest, double* numbers) noexcept = nullptr;

    /// The kinematic equation, both ways; null where there is none.
    void (*rate)(const Spec& spec, const double* numbers, const Eigen::Vector3d& w, Frame frame,
                 double* rates) noexcept = nullptr;
    Eigen::Vector3d (*angular_velocity)(const Spec& spec, const double* numbers, const double* rates,
                                        Frame frame) noexcept = nullptr;
    /// The sensitivity of numbers that are past the range of output, and of the rotation that they were read as; null
    /// where that of the rotation serves.
    Sensitivity (*sensitivity_of_numbers)(const Spec& spec, const double* numbers,
                                          const Rotation& rotation) noexcept = nullptr;

    /// The greatest value of distance(), in radians: pi/2 for Euler angles, pi for cayley, and for mrp and rotvec,
    /// which are singular at a full turn and switch their chart at a half-turn; infinite where nothing is singular.
    double greatest_distance = std::numeric_limits<double>::infinity();
    /// From the attitude of the numbers to the nearest singular one, in radians; null: always the greatest distance.
    double (*distance_to_singularity)(const Spec& spec, const double* numbers) noexcept = nullptr;
    /// Other numbers of the same attitude, where these are about to leave the range of output; null where they cannot.
    void (*switch_chart)(double* numbers) noexcept = nullptr;

    [[nodiscard]] double distance(const Spec& spec, const double* numbers) const noexcept {
        return distance_to_singularity == nullptr ? greatest_distance : distance_to_singularity(spec, numbers);
    }
};

#define ROTCONV_LINE(id) extern const Codec id;
/// One for each line of the table of representations, defined at the end of its X.cpp.
namespace codecs {
ROTCONV_REPRESENTATIONS(ROTCONV_LINE)
} // namespace codecs
#undef ROTCONV_LINE

[[nodiscard]] const Codec& codec_of(RepresentationId name) noexcept;

/// Rows from the order in which they are written, each at the beginning of one of that width, to the representation's
/// own.
void to_own_order(const Spec& spec, const double* written, std::size_t rows, double* own, std::size_t width) noexcept;
inline void to_own_order(const Spec& spec, const double* written, std::size_t rows, double* own) noexcept {
    to_own_order(spec, written, rows, own, spec.size());
}
/// And back; -0 becomes 0.
void to_written_order(const Spec& spec, const double* own, std::size_t rows, double* written) noexcept;

/// read_row() of a representation with Codec::exact_defect, or the error `defect` where its defect, in full, is above
/// the tolerance.
[[nodiscard]] Reading read_within(const Spec& spec, const double* numbers, double tolerance) noexcept;

// Codec functions from those for one row, which take what `value_of` makes of the numbers: by default one Eigen matrix
// of fixed size, which knows neither unit nor sequence.

template <class Numbers> Eigen::Map<const Numbers> plain(const Spec& /*spec*/, const double* numbers) noexcept {
    return Eigen::Map<const Numbers>(numbers);
}

template <class Numbers, auto rate, auto value_of = plain<Numbers>>
// NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
void rate_of(const Spec& spec, const double* numbers, const Eigen::Vector3d& w, Frame frame, double* rates) noexcept {
    Eigen::Map<Numbers>{rates} = rate(value_of(spec, numbers), w, frame);
}

template <class Numbers, auto angular_velocity, auto value_of = plain<Numbers>> Eigen::Vector3d
angular_velocity_of(const Spec& spec, const double* numbers, const double* rates, Frame frame) noexcept {
    return angular_velocity(value_of(spec, numbers), Eigen::Map<const Numbers>(rates), frame);
}

template <auto sensitivity> Sensitivity sensitivity_of(const Spec& /*spec*/, const Rotation& rotation) noexcept {
    return sensitivity(rotation);
}

// What presets mean for matrices and for vectors along the axis.

inline constexpr ModifierSet passive{Modifier::passive};
template <class... Texts> constexpr auto presets_that_mean(const ModifierSet& modifiers, Texts... presets) noexcept {
    return std::array{PresetMeaning{presets, modifiers}...};
}
inline constexpr auto presets_of_matrices = presets_that_mean(passive, "matlab", "basilisk", "spice", "bunge", "baruh",
                                                              "trawny", "jpl", "stuelpnagel", "colmap");
inline constexpr auto presets_of_vectors = presets_that_mean(passive, "spice", "bunge", "colmap");

} // namespace rotconv
