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

/// A function of rows of two attitudes, like Comparison::run() or Composition::run(), for one SPEC of the second.
struct PairFunction {
    using Run = std::function<void(std::span<const double> in, std::span<double> out, std::vector<RowReport>& reports,
                                   std::span<double> rest)>;
    Run run;
    std::size_t outputs = 0; ///< numbers of each row of `out`, and of `rest`
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
    std::vector<std::size_t> rows; ///< their indices among all rows
    std::vector<double> numbers;
    std::vector<double> out;
    std::vector<double> out_rest;
    std::vector<RowReport> reports; ///< by the indices among all rows
};

/// A function of rows whose second attitude lies between two rows of a reference, see stream::Pairing.
class Between {
public:
    /// @param at takes the reference's numbers as they are read; `between` takes a quaternion
    /// @param columns those of a pair by key
    /// @param settings how the neighbours are read
    Between(PairFunction at, PairFunction between, const stream::PairColumns& columns, const Spec& reference,
            const ConversionSettings& settings);

    /// A row between attitudes that are a half-turn apart has the error past_half_turn.
    void run(std::span<const double> rows, std::span<double> out, std::vector<RowReport>& reports,
             std::span<double> rest = {});

private:
    /// The quaternion at the fraction; the identity if there is none.
    [[nodiscard]] std::array<double, 4> attitude_between(std::size_t row, double fraction,
                                                         std::vector<RowReport>& reports) const;

    SomeRows at_;
    SomeRows between_; ///< rows with the quaternion between the neighbours
    stream::PairColumns columns_;
    Conversion reading_; ///< reads the neighbours
    std::vector<double> numbers_;
    std::vector<double> neighbours_; ///< the earlier and the later of each row, as quaternions
    std::vector<RowReport> neighbour_reports_;
};

} // namespace rotconv::operations
