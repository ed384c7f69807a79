#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rotconv/spec.hpp>

#include "oracle.hpp"

/// What a comparison's numbers are to be, from the definitions of the representations in many digits.
namespace fuzz {

/// R becomes left R right.
struct Turns {
    oracle::Quaternion left = oracle::Quaternion::Identity();
    oracle::Quaternion right = oracle::Quaternion::Identity();
    bool any = false;
};

/// What is compared with what, and how.
struct Compared {
    rotconv::Spec from;
    rotconv::Spec reference;
    std::optional<rotconv::Spec> product; ///< in which the product of the two is written, in the place of the angle
    double per_radian = 1.0;              ///< of the unit of the angle
    double tolerance = 1e-3;
    double lock_margin = 1e-15;
    std::size_t delta = 0; ///< not 0: the turns from each pair to the so many-th after it are compared
    /// Of the first attitude, by --left, --right and other axes. Not given: they are not modelled.
    std::optional<Turns> turns = Turns{};
};

/// The turns that those options ask for, each empty if it is not given; nothing where they are not modelled.
[[nodiscard]] std::optional<Turns> turns_of(const std::string& left, const std::string& right,
                                            const std::string& reference_axes, const std::string& body_axes,
                                            bool degrees);

enum class Agreement { yes, no, not_modelled };

/// Of a row's numbers, those of the reference last: whether the right ones are refused. Of matrices only the program
/// knows.
[[nodiscard]] Agreement check_refusal(const Compared& compared, std::span<const double> numbers, bool refused,
                                      bool of_reference);

/// The angle to 4 eps, where both attitudes are well-conditioned; 0 where the same is compared.
[[nodiscard]] Agreement check_angle(const Compared& compared, std::span<const double> numbers, double angle);

/// Remembers the attitudes of rows that are not refused, for their turns.
class ComparedTurns {
public:
    /// The angle between the turns from the pair `delta` rows before, to 32 eps; nan where there is none.
    [[nodiscard]] Agreement check_angle(const Compared& compared, std::span<const double> numbers, double angle);

private:
    using Pair = std::array<oracle::Quaternion, 2>;
    std::vector<std::optional<Pair>> pairs_; ///< nothing: not modelled
};

/// The attitude that the product's numbers stand for, likewise.
[[nodiscard]] Agreement check_product(const Compared& compared, std::span<const double> numbers,
                                      std::span<const double> product);

} // namespace fuzz
