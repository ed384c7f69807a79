#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <rotconv/euler.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// A method's answer that is further than this (radians) from the attitude is reported.
inline constexpr double reported_method_error = 1e-6;

/// Where rotconv's own two hold.
inline constexpr std::string_view every_input = "every input that describes an attitude";

/// Every pair has it: rotconv's own way, each number rounded once.
inline constexpr std::string_view default_method = "default";

/// Stands for every method of the pair.
inline constexpr std::string_view all_methods = "all";

/// The method of every pair that is rotconv's own way in plain double arithmetic: ConversionSettings::fast.
inline constexpr std::string_view fast_method = "fast";

/// A published way from one representation to another, written as it was published, weaknesses included.
struct Method {
    RepresentationId from;
    RepresentationId to;
    std::string_view name;      ///< as in --method
    std::string_view reference; ///< author, year, equation
    std::string_view domain;    ///< where it holds
    /// Rows of numbers in the representations' own order, active, in radians. Never errors: outside its domain a row
    /// may hold anything, nan included. `sequence` counts where `to` is euler.
    void (*run)(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept;

    /// Whether it is of this pair; rpy counts as euler.
    [[nodiscard]] bool serves(RepresentationId source, RepresentationId target) const noexcept;
};

/// All rows, in the order of their pairs.
[[nodiscard]] std::span<const Method> methods() noexcept;

/// The rows of a pair, see Method::serves(); empty where none is known.
[[nodiscard]] std::span<const Method> methods_of(RepresentationId from, RepresentationId to) noexcept;

/// The method of that name, or null.
[[nodiscard]] const Method* find_method(RepresentationId from, RepresentationId to, std::string_view name) noexcept;

} // namespace rotconv
