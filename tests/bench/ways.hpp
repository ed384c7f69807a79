#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "methods/method.hpp"

namespace bench {

constexpr std::size_t block = 256;                                ///< rows that stay in cache
constexpr double none = std::numeric_limits<double>::quiet_NaN(); ///< an empty field

using Run = decltype(rotconv::Method::run);

/// Eigen's way, and rotconv's as a C++ program writes it that has the types at hand; null where there is none. Eigen
/// asks for unit quaternions: where `hostile` ones may be of any length, its way makes them so first.
Run eigen_way(rotconv::RepresentationId from, rotconv::RepresentationId to, bool hostile);
Run typed_way(rotconv::RepresentationId from, rotconv::RepresentationId to);

/// Converts rows of numbers; all that it needs is made beforehand.
using Convert = std::function<void(const double* in, std::size_t rows, double* out)>;

/// A published method, rotconv's own way with all its diagnostics, `default` or `fast`, its typed call, or Eigen's way.
struct Way {
    std::string name;
    Run clean;   ///< null: rotconv's own
    Run hostile; ///< the same but for Eigen's

    [[nodiscard]] Convert between(const rotconv::Spec& from, const rotconv::Spec& to, bool is_hostile) const;
};

/// All ways of a conversion.
struct Pair {
    rotconv::RepresentationId from;
    rotconv::RepresentationId to;
    std::vector<Way> ways;

    /// Euler angles are those of `sequence`.
    [[nodiscard]] rotconv::Spec source(const char* sequence = "ZYX") const;
    [[nodiscard]] rotconv::Spec target(const char* sequence = "ZYX") const;
};

std::vector<Pair> pairs();

std::string text_of(rotconv::RepresentationId name);

} // namespace bench
