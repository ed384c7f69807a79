#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <rotconv/euler.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// An answer that is further than this (radians) from the attitude is reported.
inline constexpr double reported_method_error = 1e-6;

/// The domain of rotconv's own two methods.
inline constexpr std::string_view every_input = "every input that describes an attitude";

/// The method of every pair that is rotconv's own conversion, each number rounded once.
inline constexpr std::string_view default_method = "default";

/// Stands for every method of the pair.
inline constexpr std::string_view all_methods = "all";

/// The method of every pair that is rotconv's own conversion in plain double arithmetic: ConversionSettings::fast.
inline constexpr std::string_view fast_method = "fast";

/// A published conversion from one representation to another, written as it was published, with its weaknesses.
struct Method {
    RepresentationId from;
    RepresentationId to;
    std::string_view name;      ///< as in --method
    std::string_view reference; ///< author, year, equation
    std::string_view domain;    ///< the valid range, in words
    /// Converts rows of numbers in the representations' own order, active, in radians; never fails. Outside the domain
    /// a row may hold anything, including nan. `sequence` is used if `to` is euler.
    void (*run)(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept;

    /// Whether the method is one of this pair; rpy counts as euler.
    [[nodiscard]] bool serves(RepresentationId source, RepresentationId target) const noexcept;
};

/// All methods, in the order of their pairs.
[[nodiscard]] std::span<const Method> methods() noexcept;

/// The methods of a pair, see Method::serves(); empty if none is known.
[[nodiscard]] std::span<const Method> methods_of(RepresentationId from, RepresentationId to) noexcept;

/// The method of that name, or null.
[[nodiscard]] const Method* find_method(RepresentationId from, RepresentationId to, std::string_view name) noexcept;

} // namespace rotconv
