#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <rotconv/comparison.hpp>

#include "../core/interpolation.hpp"

namespace rotconv::operations {

/// Compares attitudes with a reference that lies between two rows.
class ComparisonBetween {
public:
    explicit ComparisonBetween(const Comparison& comparison)
        : comparison_(comparison), from_between_(comparison.from(), Spec{}, comparison.settings()),
          reading_(comparison.reference(), Spec{},
                   {.tolerance = comparison.settings().reading.tolerance,
                    .sensitivity = comparison.settings().reading.sensitivity}) {}

    /// Like Comparison::run(), of rows as stream::Pairing has them. A row between attitudes that are half a turn apart
    /// has the error past_half_turn.
    void run(std::span<const double> rows, std::span<double> out, std::vector<RowReport>& reports) {
        const std::size_t n = comparison_.from().size();
        const std::size_t m = comparison_.reference().size();
        const std::size_t width = 1 + n + 1 + m + m + 1;
        const std::size_t count = rows.size() / width;
        const auto part = [&](std::size_t row, std::size_t first, std::size_t size) {
            return rows.subspan(row * width + first, size);
        };
        found_.assign(count, std::nullopt);
        for (Neighbour* neighbour : {&earlier_, &later_}) {
            const std::size_t first = neighbour == &earlier_ ? 2 + n : 2 + n + m;
            neighbour->numbers.clear();
            for (std::size_t i = 0; i < count; ++i) {
                append(neighbour->numbers, part(i, first, m));
            }
            neighbour->attitudes.resize(4 * count);
            reading_.run(neighbour->numbers, neighbour->attitudes, neighbour->reports);
        }
        at_.clear();
        between_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const double fraction = part(i, width - 1, 1).front();
            Compared& compared = fraction > 0.0 ? between_ : at_; // the reference has the row's key: its own numbers
            compared.rows.push_back(i);
            append(compared.numbers, part(i, 1, n));
            if (fraction > 0.0) {
                append(compared.numbers, attitude_between(i, fraction));
            } else {
                append(compared.numbers, part(i, 2 + n, m));
            }
        }
        run(comparison_, at_, out);
        run(from_between_, between_, out);
        for (const Neighbour* neighbour : {&earlier_, &later_}) {
            for (const RowReport& report : neighbour->reports) {
                add(report, neighbour == &later_);
            }
        }
        reports.clear();
        for (std::size_t i = 0; i < count; ++i) {
            if (found_[i]) {
                found_[i]->row = i;
                reports.push_back(*found_[i]);
                if (found_[i]->error != Error::none) {
                    const std::size_t size = comparison_.outputs();
                    std::fill_n(out.data() + i * size, size, std::numeric_limits<double>::quiet_NaN());
                }
            }
        }
    }

private:
    struct Neighbour {
        std::vector<double> numbers;
        std::vector<double> attitudes; ///< quaternions
        std::vector<RowReport> reports;
    };
    /// Rows of one comparison.
    struct Compared {
        std::vector<std::size_t> rows; ///< among all
        std::vector<double> numbers;
        std::vector<double> out;
        std::vector<RowReport> reports;

        void clear() noexcept {
            rows.clear();
            numbers.clear();
        }
    };

    static void append(std::vector<double>& to, std::span<const double> numbers) {
        to.insert(to.end(), numbers.begin(), numbers.end());
    }

    /// The quaternion at the fraction; the identity where there is none.
    [[nodiscard]] std::array<double, 4> attitude_between(std::size_t row, double fraction) {
        const auto attitude = [row](const Neighbour& neighbour) {
            const auto q = std::span(neighbour.attitudes).subspan(4 * row, 4);
            return Rotation::near_unit(q[0], q[1], q[2], q[3]);
        };
        if (std::isnan(attitude(earlier_).w()) || std::isnan(attitude(later_).w())) {
            return {1.0}; // which is reported of them
        }
        const auto found = interpolated(attitude(earlier_), attitude(later_), fraction);
        if (!found) {
            found_[row] = RowReport{.error = Error::past_half_turn, .of_reference = true};
            return {1.0};
        }
        return {found->w(), found->x(), found->y(), found->z()};
    }

    void run(const Comparison& comparison, Compared& compared, std::span<double> out) {
        const std::size_t size = comparison.outputs();
        compared.out.resize(compared.rows.size() * size);
        comparison.run(compared.numbers, compared.out, compared.reports);
        for (std::size_t i = 0; i < compared.rows.size(); ++i) {
            std::copy_n(compared.out.data() + i * size, size, out.data() + compared.rows[i] * size);
        }
        for (const RowReport& report : compared.reports) {
            auto& found = found_[compared.rows[report.row]];
            found = found && report.error == Error::none ? found : report;
        }
    }

    /// Adds the report of a neighbour to that of the row, whose own error counts before it.
    void add(const RowReport& report, bool of_later) {
        auto& found = found_[report.row];
        const bool is_between = std::ranges::binary_search(between_.rows, report.row);
        if (!is_between || (found && found->error != Error::none)) {
            return;
        }
        if (report.error != Error::none) {
            found = RowReport{.error = report.error, .of_reference = true, .of_later = of_later};
            found->defect = report.defect;
        } else if (!of_later) { // the row after it tells of the later
            found = found.value_or(RowReport{});
            found->reference_defect = report.defect;
            found->diagnostics |= report.diagnostics;
        }
    }

    Comparison comparison_;
    Comparison from_between_; ///< with the quaternion between the neighbours
    Conversion reading_;      ///< of the neighbours
    Neighbour earlier_;
    Neighbour later_;
    Compared at_;
    Compared between_;
    std::vector<std::optional<RowReport>> found_; ///< of each row
};

} // namespace rotconv::operations
