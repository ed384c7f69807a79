#include <rotconv/continuous.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../checks.hpp"
#include "../numerics/power_of_two.hpp"
#include "../numerics/wide.hpp"
#include "../representations/codec.hpp"

namespace rotconv {

bool ContinuousNumbers::have_choice() const noexcept { return codec_of(spec_.name).choose_nearest != nullptr; }

void ContinuousNumbers::run(std::span<double> numbers, std::span<const RowReport> reports, std::span<const double> rest,
                            const Again& again) {
    if (!have_choice()) {
        return;
    }
    static constexpr std::array<double, most_numbers> nothing{};
    const std::size_t size = spec_.size();
    auto report = reports.begin();
    const std::size_t rows = checked_rows(numbers.size(), size, rest.empty() ? numbers.size() : rest.size(), size);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto own = numbers.subspan(row * size, size);
        const bool is_reported = report != reports.end() && report->row == row;
        const Error error = is_reported ? report->error : Error::none;
        const DiagnosticSet diagnostics = is_reported ? report->diagnostics : DiagnosticSet();
        report += is_reported ? 1 : 0;
        if (error != Error::none || !all_finite(own.data(), size)) {
            continue;
        }
        if (has_last_) {
            choose(own, diagnostics, rest.empty() ? std::span(nothing).first(size) : rest.subspan(row * size, size),
                   again, row);
        }
        std::ranges::copy(own, last_.begin());
        has_last_ = true;
    }
}

void ContinuousNumbers::choose(std::span<double> own, DiagnosticSet diagnostics, std::span<const double> rest,
                               const Again& again, std::size_t row) {
    const auto choose_nearest = codec_of(spec_.name).choose_nearest;
    std::array<double, most_numbers> canonical{};
    std::ranges::copy(own, canonical.begin());
    if (choose_nearest(spec_, last_.data(), diagnostics, rest, own.data()) || !again) {
        return;
    }
    constexpr std::size_t rest_size = Wide::bits_of_rest / 53;
    std::array<double, most_numbers> numbers{};
    std::array<double, rest_size * most_numbers> more{};
    const auto all = std::span(more).first(rest_size * own.size());
    again(row, std::span(numbers).first(own.size()), all);
    if (std::equal(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(own.size()), canonical.begin())) {
        std::ranges::copy_n(canonical.begin(), static_cast<std::ptrdiff_t>(own.size()), own.begin());
        static_cast<void>(choose_nearest(spec_, last_.data(), diagnostics, all, own.data()));
    }
}

void ContinuousNumbers::next(const Rotation& attitude, std::span<double> numbers) {
    check_size(numbers.size(), spec_.size());
    std::array<double, most_numbers> own{};
    RowReport report;
    report.diagnostics =
        write_row(spec_, spec_.passive ? attitude.inverse() : attitude, own.data(), euler::default_lock_margin);
    to_written_order(spec_, own.data(), 1, numbers.data());
    run(numbers.first(spec_.size()), {&report, 1});
}

} // namespace rotconv
