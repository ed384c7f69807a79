#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <Eigen/Core>

#include <rotconv/frame.hpp>
#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

#include "rotation_batch.hpp"

namespace rotconv {

/// All that is known of a representation. Functions take numbers in the representation's own order and the attitude not
/// yet inverted: of a Spec's conventions the sequence and the unit are left to them.
struct Codec {
    Representation representation{};

    /// Reads a batch of rows, at most `batch_rows` of them.
    void (*read)(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept = nullptr;
    /// The defect in full, where `read` returns a bound only; null elsewhere.
    double (*exact_defect)(const double* numbers) noexcept = nullptr;
    /// Writes a batch of rows and finds what there is to remark on each.
    void (*write)(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
                  DiagnosticSet* diagnostics) noexcept = nullptr;
    Sensitivity (*sensitivity)(const Spec& spec, const Rotation& rotation) noexcept = nullptr;

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

    /// One row.
    [[nodiscard]] Reading read_row(const Spec& spec, const double* numbers) const noexcept {
        Readings one; // NOLINT(*-member-init)
        read(spec, numbers, 1, one);
        return one.reading(0);
    }

    /// One row, with nothing given up to lock.
    void write_row(const Spec& spec, const Rotation& rotation, double* numbers) const noexcept {
        DiagnosticSet diagnostics;
        write(spec, 0.0, OneRotation(rotation), 1, numbers, &diagnostics);
    }

    [[nodiscard]] double distance(const Spec& spec, const double* numbers) const noexcept {
        return distance_to_singularity == nullptr ? greatest_distance : distance_to_singularity(spec, numbers);
    }
};

#define ROTCONV_LINE(id) extern const Codec id;
/// One for each line of the table of representations, defined at the end of its source.
namespace codecs {
ROTCONV_REPRESENTATIONS(ROTCONV_LINE)
} // namespace codecs
#undef ROTCONV_LINE

[[nodiscard]] const Codec& codec_of(RepresentationId name) noexcept;

/// No representation has more.
inline constexpr std::size_t most_numbers = 9;

/// Where neither sequence nor unit counts.
inline constexpr Spec plain_spec{};

// Codec functions of what is written for one row, and of numbers that are one Eigen matrix of fixed size and know
// neither unit nor sequence.

template <std::size_t size, auto read_one>
void read_each(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        readings.set(i, read_one(spec, numbers + size * i));
    }
}

template <class Numbers, auto to_rotation> Reading read_plain(const Spec& /*spec*/, const double* numbers) noexcept {
    return to_rotation(Eigen::Map<const Numbers>(numbers));
}

// NOLINTBEGIN(readability-non-const-parameter): the maps write through them
template <class Numbers, auto from_rotation> void write_plain(const Spec& /*spec*/, double /*lock_margin*/,
                                                              const Rotations& rotations, std::size_t rows,
                                                              double* numbers, DiagnosticSet* diagnostics) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        Eigen::Map<Numbers>{numbers + i* Numbers::SizeAtCompileTime} = from_rotation(rotations.at(i));
        diagnostics[i] = {};
    }
}

template <class Numbers, auto defect> double defect_plain(const double* numbers) noexcept {
    return defect(Eigen::Map<const Numbers>(numbers));
}

template <auto sensitivity> Sensitivity sensitivity_plain(const Spec& /*spec*/, const Rotation& rotation) noexcept {
    return sensitivity(rotation);
}

template <class Numbers, auto rate> void rate_plain(const Spec& /*spec*/, const double* numbers,
                                                    const Eigen::Vector3d& w, Frame frame, double* rates) noexcept {
    Eigen::Map<Numbers>{rates} = rate(Eigen::Map<const Numbers>(numbers), w, frame);
}
// NOLINTEND(readability-non-const-parameter)

template <class Numbers, auto angular_velocity> Eigen::Vector3d
angular_velocity_plain(const Spec& /*spec*/, const double* numbers, const double* rates, Frame frame) noexcept {
    return angular_velocity(Eigen::Map<const Numbers>(numbers), Eigen::Map<const Numbers>(rates), frame);
}

// What presets mean for matrices and for vectors along the axis.

inline constexpr auto presets_of_matrices = std::to_array<PresetMeaning>({{"matlab", {Modifier::passive}},
                                                                          {"basilisk", {Modifier::passive}},
                                                                          {"spice", {Modifier::passive}},
                                                                          {"bunge", {Modifier::passive}},
                                                                          {"baruh", {Modifier::passive}},
                                                                          {"trawny", {Modifier::passive}},
                                                                          {"stuelpnagel", {Modifier::passive}}});

inline constexpr auto presets_of_vectors =
    std::to_array<PresetMeaning>({{"spice", {Modifier::passive}}, {"bunge", {Modifier::passive}}});

} // namespace rotconv
