#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rotconv/spec.hpp>

namespace accuracy {

/// What became of numbers that are to be the doubles nearest to the exact function of the numbers read.
struct Rounding {
    std::size_t rows = 0;
    std::size_t numbers = 0;
    std::size_t wrong = 0;
    std::size_t uncertain = 0; ///< where the oracle itself cannot tell

    Rounding& operator+=(const Rounding& other) noexcept;
    [[nodiscard]] std::size_t correct() const noexcept { return numbers - wrong - uncertain; }
};

/// Converts the rows and compares bits with the oracle; the first three wrong numbers are printed. Rows in error, and
/// quaternions that keep their bits, do not count.
Rounding rounding_of(const rotconv::Spec& from, const rotconv::Spec& to, const std::vector<std::vector<double>>& rows);
/// The same on all strata, about `size` rows in each.
Rounding rounding_of(const std::string& from, const std::string& to, int size);

/// SPECs between which every pair is compared.
const std::vector<std::string>& compared_specs();

} // namespace accuracy
