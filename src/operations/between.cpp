#include "between.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rotconv::operations {
namespace {

/// The function of rows whose second attitude is interpolated in a reference, see stream::Pairing.
class BetweenRows {
public:
    /// See of_pairs().
    BetweenRows(RowFunction at, RowFunction between, std::size_t first_size, const Spec& reference,
                const ConversionSettings& settings, bool by_numbers)
        : at_(std::move(at)), between_(std::move(between)), first_size_(first_size), by_numbers_(by_numbers),
          reading_(reference, Spec{}, {.tolerance = settings.tolerance, .sensitivity = settings.sensitivity}) {}

    std::size_t operator()(const stream::NumberRows& pairs, std::span<double> out, std::vector<RowReport>& reports,
                           std::span<double> rest);

private:
    /// The quaternion at the place; the identity if there is none.
    [[nodiscard]] std::array<double, 4> attitude_at(std::size_t row, const stream::InterpolatedPair& place,
                                                    std::vector<RowReport>& reports) const;
    /// Adds to the report on a row what is to be told of its neighbours.
    void add_neighbours(std::size_t row, const stream::InterpolatedPair& place, std::vector<RowReport>& reports) const;

    RowSubset at_;
    RowSubset between_; ///< rows with the quaternion between the neighbours, or the numbers of both
    std::size_t first_size_;
    bool by_numbers_;
    Conversion reading_;            ///< reads the neighbours
    std::vector<double> attitudes_; ///< the neighbours as quaternions
    std::vector<RowReport> neighbour_reports_;
};

std::size_t BetweenRows::operator()(const stream::NumberRows& pairs, std::span<double> out,
                                    std::vector<RowReport>& reports, std::span<double> rest) {
    const std::size_t second_size = reading_.from().size();
    const std::size_t count = pairs.between.size();
    attitudes_.resize(4 * (pairs.neighbours.size() / second_size));
    reading_.run(pairs.neighbours, attitudes_, neighbour_reports_);
    at_.clear();
    between_.clear();
    reports.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const stream::InterpolatedPair& row = pairs.between[i];
        const auto attitude = row.is_at_row() ? std::array<double, 4>() : attitude_at(i, row, reports);
        const bool is_at = by_numbers_ ? is_at_row(pairs, i, second_size) : row.is_at_row();
        RowSubset& some = is_at ? at_ : between_;
        some.rows.push_back(i);
        if (is_at || by_numbers_) {
            append_pair(pairs, i, first_size_, second_size, some.numbers);
        } else {
            append(some.numbers, std::span(pairs.numbers).subspan(i * first_size_, first_size_));
            append(some.numbers, attitude);
        }
    }
    const std::size_t size = out.size() / std::max<std::size_t>(count, 1);
    for (RowSubset* some : {&at_, &between_}) {
        some->run(size, out, size, rest);
        for (const RowReport& report : some->reports) { // the row's own error comes before those of the neighbours
            RowReport& found = stream::report_of(report.row, reports);
            found = found.error != Error::none && report.error == Error::none ? found : report;
        }
    }
    for (std::size_t i = 0; i < count && !neighbour_reports_.empty(); ++i) {
        if (!pairs.between[i].is_at_row()) {
            add_neighbours(i, pairs.between[i], reports);
        }
    }
    for (const RowReport& report : reports) {
        if (report.error != Error::none) {
            std::fill_n(out.data() + report.row * size, size, std::numeric_limits<double>::quiet_NaN());
        }
    }
    return count;
}

std::array<double, 4> BetweenRows::attitude_at(std::size_t row, const stream::InterpolatedPair& place,
                                               std::vector<RowReport>& reports) const {
    const Rotation earlier = rotation_at(attitudes_.data() + 4 * place.earlier);
    const Rotation later = rotation_at(attitudes_.data() + 4 * place.later);
    if (std::isnan(earlier.w()) || std::isnan(later.w())) {
        return {1.0}; // their own errors are reported
    }
    const auto found = interpolate(earlier, later, place.fraction());
    if (!found) {
        reports.push_back({.row = row, .error = Error::past_half_turn, .at_fault = 1});
    }
    return found.value_or(Rotation()).components();
}

void BetweenRows::add_neighbours(std::size_t row, const stream::InterpolatedPair& place,
                                 std::vector<RowReport>& reports) const {
    const std::array neighbours{place.earlier, place.later};
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
        const auto report = std::ranges::lower_bound(neighbour_reports_, neighbours.at(k), {}, &RowReport::row);
        if (report == neighbour_reports_.end() || report->row != neighbours.at(k)) {
            continue;
        }
        RowReport& found = stream::report_of(row, reports);
        if (found.error == Error::none && report->error != Error::none) {
            found = {.row = row, .error = report->error, .at_fault = k + 1, .defect = report->defect};
        } else if (found.error == Error::none) {
            found.references.at(k) = {report->defect, report->unusual};
            found.diagnostics |= report->diagnostics;
        }
    }
}

} // namespace

RowFunction of_pairs(RowFunction at, RowFunction between, const PairedRows& rows, std::size_t first_size,
                     const Spec& second, const ConversionSettings& settings, bool by_numbers) {
    return rows.interpolates
               ? RowFunction(BetweenRows(std::move(at), std::move(between), first_size, second, settings, by_numbers))
               : at;
}

bool is_at_row(const stream::NumberRows& pairs, std::size_t row, std::size_t second_size) {
    const auto neighbour = [&](std::size_t at) {
        return std::span(pairs.neighbours).subspan(at * second_size, second_size);
    };
    return std::ranges::equal(neighbour(pairs.between[row].earlier), neighbour(pairs.between[row].later));
}

void append_pair(const stream::NumberRows& pairs, std::size_t row, std::size_t first_size, std::size_t second_size,
                 std::vector<double>& numbers) {
    const stream::InterpolatedPair& between = pairs.between[row];
    append(numbers, std::span(pairs.numbers).subspan(row * first_size, first_size));
    append(numbers, std::span(pairs.neighbours).subspan(between.earlier * second_size, second_size));
    if (is_at_row(pairs, row, second_size)) {
        return;
    }
    append(numbers, std::span(pairs.neighbours).subspan(between.later * second_size, second_size));
    for (const stream::KeyDistance& distance : {between.way, between.whole}) {
        constexpr std::uint64_t mask = (std::uint64_t{1} << 43U) - 1;
        for (const unsigned places : {86U, 43U, 0U}) {
            const auto digits = static_cast<std::uint64_t>(distance.units >> places) & mask;
            numbers.push_back(std::ldexp(static_cast<double>(digits), static_cast<int>(places)));
        }
    }
}

void RowSubset::run(std::size_t size, std::span<double> to, std::size_t width, std::span<double> rest) {
    out.resize(rows.size() * size);
    out_rest.resize(rest.empty() ? 0 : out.size());
    stream::NumberRows held;
    held.numbers.append(numbers);
    function(held, out, reports, out_rest);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::copy_n(out.data() + i * size, size, to.data() + rows[i] * width);
        if (!rest.empty()) {
            std::copy_n(out_rest.data() + i * size, size, rest.data() + rows[i] * width);
        }
    }
    std::ranges::for_each(reports, [this](RowReport& report) { report.row = rows[report.row]; });
}

} // namespace rotconv::operations
