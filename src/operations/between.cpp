#include "between.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rotconv::operations {
namespace {

/// Copies rows of `size` numbers to their places among rows of `width`.
void scatter(std::span<const double> from, std::size_t size, std::span<const std::size_t> rows, std::span<double> to,
             std::size_t width) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::copy_n(from.data() + i * size, size, to.data() + rows[i] * width);
    }
}

/// A function of rows whose second attitude lies between two rows of a reference, see stream::Pairing.
class Between {
public:
    /// See of_pairs().
    Between(RowFunction at, RowFunction between, const stream::PairColumns& columns, const Spec& reference,
            const ConversionSettings& settings)
        : at_(std::move(at)), between_(std::move(between)), columns_(columns),
          reading_(reference, Spec{}, {.tolerance = settings.tolerance, .sensitivity = settings.sensitivity}) {}

    std::size_t operator()(const stream::NumberRows& pairs, std::span<double> out, std::vector<RowReport>& reports,
                           std::span<double> rest);

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

std::size_t Between::operator()(const stream::NumberRows& pairs, std::span<double> out, std::vector<RowReport>& reports,
                                std::span<double> rest) {
    const std::span<const double> rows = pairs.numbers;
    const std::size_t width = columns_.width();
    const std::size_t count = rows.size() / width;
    numbers_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        append(numbers_, rows.subspan(i * width + columns_.first_size, 2 * columns_.second_size));
    }
    neighbours_.resize(8 * count);
    reading_.run(numbers_, neighbours_, neighbour_reports_);
    at_.clear();
    between_.clear();
    reports.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = rows.subspan(i * width, width);
        const double fraction = row[columns_.fraction()];
        SomeRows& some = fraction > 0.0 ? between_ : at_; // at 0 the reference has the row's key
        some.rows.push_back(i);
        append(some.numbers, row.first(columns_.first_size));
        if (fraction > 0.0) {
            append(some.numbers, attitude_between(i, fraction, reports));
        } else {
            append(some.numbers, row.subspan(columns_.first_size, columns_.second_size));
        }
    }
    const std::size_t size = out.size() / std::max<std::size_t>(count, 1);
    for (SomeRows* some : {&at_, &between_}) {
        some->run(size, out, size, rest);
        for (const RowReport& report : some->reports) { // the row's own error comes before those of the neighbours
            RowReport& found = stream::report_of(report.row, reports);
            found = found.error != Error::none && report.error == Error::none ? found : report;
        }
    }
    for (const RowReport& report : neighbour_reports_) {
        const std::size_t row = report.row / 2;
        const bool is_later = report.row % 2 == 1;
        const bool is_between = rows[row * width + columns_.fraction()] > 0.0;
        if (!is_between || (is_later && report.error == Error::none)) { // the next row reports the later one
            continue;
        }
        RowReport& found = stream::report_of(row, reports);
        if (found.error == Error::none && report.error != Error::none) {
            found = {
                .row = row, .error = report.error, .of_reference = true, .of_later = is_later, .defect = report.defect};
        } else if (found.error == Error::none) {
            found.reference_defect = report.defect;
            found.reference_unusual = report.unusual;
            found.diagnostics |= report.diagnostics;
        }
    }
    for (const RowReport& report : reports) {
        if (report.error != Error::none) {
            std::fill_n(out.data() + report.row * size, size, std::numeric_limits<double>::quiet_NaN());
        }
    }
    return count;
}

std::array<double, 4> Between::attitude_between(std::size_t row, double fraction,
                                                std::vector<RowReport>& reports) const {
    const Rotation earlier = rotation_at(neighbours_.data() + 8 * row);
    const Rotation later = rotation_at(neighbours_.data() + 8 * row + 4);
    if (std::isnan(earlier.w()) || std::isnan(later.w())) {
        return {1.0}; // their own errors are reported
    }
    const auto found = interpolate(earlier, later, fraction);
    if (!found) {
        reports.push_back({.row = row, .error = Error::past_half_turn, .of_reference = true});
    }
    return found.value_or(Rotation()).components();
}

} // namespace

RowFunction of_pairs(RowFunction at, RowFunction between, const stream::PairColumns& columns, const Spec& second,
                     const ConversionSettings& settings) {
    if (columns.interpolates) {
        return Between(std::move(at), std::move(between), columns, second, settings);
    }
    return at;
}

void SomeRows::run(std::size_t size, std::span<double> to, std::size_t width, std::span<double> rest) {
    out.resize(rows.size() * size);
    out_rest.resize(rest.empty() ? 0 : out.size());
    function({numbers, {}}, out, reports, out_rest);
    scatter(out, size, rows, to, width);
    if (!rest.empty()) {
        scatter(out_rest, size, rows, rest, width);
    }
    std::ranges::for_each(reports, [this](RowReport& report) { report.row = rows[report.row]; });
}

} // namespace rotconv::operations
