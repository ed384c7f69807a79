#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <rotconv/conversion.hpp>
#include <rotconv/rotation.hpp>

#include "../core/representations/rotation_angle.hpp"
#include "../stream/rows/row_operation.hpp"
#include "operations.hpp"

namespace rotconv::operations {

inline void append(std::vector<double>& to, std::span<const double> numbers) {
    to.insert(to.end(), numbers.begin(), numbers.end());
}

/// The function of rows of two attitudes as they are read. A row between neighbours that are half a turn apart has the
/// error past_half_turn.
/// @param at takes the second attitude as it is read, and `between` as a quaternion or, with `by_numbers`, as
/// Composition::interpolating()
/// @param first_size numbers of the first attitude
/// @param settings how neighbours are read
[[nodiscard]] RowFunction of_pairs(RowFunction at, RowFunction between, const PairedRows& rows, std::size_t first_size,
                                   const Spec& second, const ConversionSettings& settings, bool by_numbers = false);

/// Whether a row needs one row of the reference alone: there is one with its key, or the two around it are the same.
[[nodiscard]] bool is_at_row(const stream::NumberRows& pairs, std::size_t row, std::size_t second_size);
/// Adds the numbers of a row and those of the reference for it, as Composition or its interpolating() takes them.
void append_pair(const stream::NumberRows& pairs, std::size_t row, std::size_t first_size, std::size_t second_size,
                 std::vector<double>& numbers);

/// A function of some of the rows at hand.
struct RowSubset {
    explicit RowSubset(RowFunction of_pairs) : function(std::move(of_pairs)) {}

    void clear() noexcept {
        rows.clear();
        numbers.clear();
    }
    /// Puts the results, of `size` numbers each, in their places among rows of `width` numbers; `rest` may be empty.
    void run(std::size_t size, std::span<double> to, std::size_t width, std::span<double> rest = {});

    RowFunction function;
    std::vector<std::size_t> rows; ///< their indices among all rows
    std::vector<double> numbers;
    std::vector<double> out;
    std::vector<double> out_rest;
    std::vector<RowReport> reports; ///< by the indices among all rows
};

} // namespace rotconv::operations
