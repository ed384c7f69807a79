#include <rotconv/continuous.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../checks.hpp"
#include "../numerics/power_of_two.hpp"
#include "../representations/codec.hpp"

namespace rotconv {

ContinuousNumbers::ContinuousNumbers(const Spec& spec) noexcept : spec_(spec), codec_(&codec_of(spec.name)) {}

bool ContinuousNumbers::have_choice() const noexcept { return codec_->choose_nearest != nullptr; }

void ContinuousNumbers::run(std::span<double> numbers, std::span<const RowReport> reports,
                            std::span<const double> rest) {
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
            codec_->choose_nearest(spec_, last_.data(), diagnostics, rest.empty() ? nothing.data() : &rest[row * size],
                                   own.data());
        }
        std::ranges::copy(own, last_.begin());
        has_last_ = true;
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
