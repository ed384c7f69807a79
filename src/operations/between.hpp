#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <rotconv/conversion.hpp>
#include <rotconv/rotation.hpp>

#include "../stream/row_operation.hpp"

namespace rotconv::operations {

inline void append(std::vector<double>& to, std::span<const double> numbers) {
    to.insert(to.end(), numbers.begin(), numbers.end());
}

[[nodiscard]] inline Rotation rotation_at(const double* q) noexcept {
    return Rotation::near_unit(q[0], q[1], q[2], q[3]);
}

/// The report on the row among reports in the order of the rows; an empty one is added if there is none.
[[nodiscard]] RowReport& report_of(std::size_t row, std::vector<RowReport>& reports);

/// What is made of rows of two attitudes, like Comparison::run() or Composition::run(), where the second has a SPEC.
struct PairFunction {
    using Run = std::function<void(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                                   std::span<double> rest)>;
    Run run;
    std::size_t outputs = 0; ///< numbers of a row of `out`, and of `rest`
};

/// A function of some of the rows at hand.
struct SomeRows {
    explicit SomeRows(PairFunction of_pairs) : function(std::move(of_pairs)) {}

    void clear() noexcept {
        rows.clear();
        numbers.clear();
    }
    /// Puts the results in their places among rows of `width` numbers; `rest` may be empty.
    void run(std::span<double> to, std::size_t width, std::span<double> rest = {});

    PairFunction function;
    std::vector<std::size_t> rows; ///< their indices among all
    std::vector<double> numbers;
    std::vector<double> out;
    std::vector<double> out_rest;
    std::vector<RowReport> reports; ///< by the indices among all
};

/// A function of rows whose second attitude lies between two rows of a reference, as stream::Pairing has them.
class Between {
public:
    /// @param at takes the reference as it is read, `between` as a quaternion
    /// @param columns of a pair by key
    /// @param settings of reading
    Between(PairFunction at, PairFunction between, const stream::PairColumns& columns, const Spec& reference,
            const ConversionSettings& settings);

    /// A row between attitudes that are half a turn apart has the error past_half_turn.
    void run(std::span<const double> rows, std::span<double> out, std::vector<RowReport>& reports,
             std::span<double> rest = {});

private:
    /// The quaternion at the fraction; the identity where there is none.
    [[nodiscard]] std::array<double, 4> attitude_between(std::size_t row, double fraction,
                                                         std::vector<RowReport>& reports) const;

    SomeRows at_;
    SomeRows between_; ///< with the quaternion between the neighbours
    stream::PairColumns columns_;
    Conversion reading_; ///< of the neighbours
    std::vector<double> numbers_;
    std::vector<double> neighbours_; ///< of each row the earlier and the later, as quaternions
    std::vector<RowReport> neighbour_reports_;
};

} // namespace rotconv::operations
