#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>

namespace rotconv {

/// Kinds of rows on which conversions are known to fail: attitudes that are uniform, small, near a half-turn, near
/// lock, on the border between quaternion components, and the rotations of a cube; then quaternions of other lengths,
/// matrices and columns with noise, and angles and vectors of many turns. The manual of `rotconv sample` has their
/// figures.
enum class SampleKind : std::uint8_t { uniform, small, half_turn, lock, border, cube, scaled, noise, many_turns };

inline constexpr std::array<std::string_view, 9> sample_kind_names{
    "uniform", "small", "half-turn", "lock", "border", "cube", "scaled", "noise", "many-turns"};
inline constexpr std::size_t usual_sample_kinds = 6; ///< the first of them: every representation has these

[[nodiscard]] constexpr std::string_view name_of(SampleKind kind) noexcept {
    return sample_kind_names[static_cast<std::size_t>(kind)];
}
/// The kinds that a representation has, in their order.
[[nodiscard]] std::vector<SampleKind> sample_kinds_of(RepresentationId name);

struct SampleSettings {
    std::vector<SampleKind> kinds; ///< they take turns, row by row
    std::uint64_t seed = 0;
    double noise = 5e-4; ///< the most by which a number of SampleKind::noise is off
};

/// Rows of numbers on which to try conversions. A row depends on its index, the spec and the settings alone, to the
/// bit, on every machine. It is finite, and an attitude of any defect: cayley has no half-turns. Most rows are rounded
/// from a quaternion of doubles; angles near lock, and those of `scaled`, `noise` and `many_turns`, are chosen as
/// numbers.
class Sampler {
public:
    /// @pre the representation has each of the kinds, and there is one
    Sampler(const Spec& spec, SampleSettings settings);

    /// Makes the rows of these indices, whole numbers from 0 to 2^53.
    /// @throw std::invalid_argument if out.size() < rows.size() * spec.size()
    void run(std::span<const double> rows, std::span<double> out);

private:
    /// A quaternion other than 0.
    [[nodiscard]] std::array<double, 4> attitude_of(std::uint64_t row) const;
    /// Replaces the attitude's numbers in rows that are chosen otherwise.
    void choose_numbers(std::uint64_t row, std::span<double> numbers) const;

    Conversion conversion_; ///< from quat
    SampleSettings settings_;
    std::vector<std::array<double, 4>> cube_;
    std::vector<double> attitudes_; ///< for the rows at hand
    std::vector<RowReport> reports_;
};

} // namespace rotconv
