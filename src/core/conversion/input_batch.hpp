#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../checks.hpp"
#include "../representations/codec.hpp"

namespace rotconv {

/// Constant rotations, as kernels take them.
[[nodiscard]] FixedRotations fixed_rotations(const FixedRotation& left, const FixedRotation& right) noexcept;

/// The error of numbers as they were read, or their defect, of which a bound is given, what is unusual about them, and
/// whether it is to be reported.
/// @param is_exact the defect is needed in full
[[nodiscard]] RowReport report_of(const Spec& spec, const double* numbers, Error error, double defect, double tolerance,
                                  bool is_exact) noexcept;

/// A batch of rows of a SPEC and the attitudes that they describe, once a kernel has read them.
class InputBatch {
public:
    /// @param spec must outlive this
    /// @param in as written, at most `batch_rows` rows, which must outlive this
    /// @param width numbers of a row, of which these are the first
    InputBatch(const Spec& spec, const double* in, std::size_t rows, std::size_t width) noexcept
        : codec_(&codec_of(spec.name)), spec_(&spec), own_(in), size_(spec.size()),
          may_be_unusual_(codec_->representation.has_angles() &&
                          (spec.unit == AngleUnit::radians || codec_->representation.first_angle > 0)) {
        if (spec.is_reordered() || width != size_) {
            to_own_order(spec, in, rows, own_order_.data(), width);
            own_ = own_order_.data();
        }
    }

    /// The numbers in the representation's own order.
    [[nodiscard]] const double* own() const noexcept { return own_; }

    /// Whether report() may have something to tell of the row.
    [[nodiscard]] bool is_remarkable(std::size_t row, const ConversionSettings& settings) const noexcept {
        return attitudes.error[row] != Error::none || !(attitudes.defect[row] <= largest_unreported(settings)) ||
               (may_be_unusual_ && is_unusual(row));
    }
    /// The same of all, without a branch: compilers vectorise sums of bits.
    [[nodiscard]] bool any_remarkable(std::size_t rows, const ConversionSettings& settings) const noexcept {
        const double largest_defect = largest_unreported(settings);
        std::uint64_t defects = 0;
        for (std::size_t i = 0; i < rows; ++i) {
            defects |= attitudes.defect[i] <= largest_defect ? 0U : 1U;
        }
        std::uint8_t errors = 0;
        for (std::size_t i = 0; i < rows; ++i) {
            errors = static_cast<std::uint8_t>(errors | static_cast<std::uint8_t>(attitudes.error[i]));
        }
        bool unusual = false;
        for (std::size_t i = 0; may_be_unusual_ && i < rows; ++i) {
            unusual |= is_unusual(i);
        }
        return defects != 0 || errors != 0 || unusual;
    }
    [[nodiscard]] RowReport report(std::size_t row, const ConversionSettings& settings) const noexcept {
        return report_of(*spec_, own_ + row * size_, attitudes.error[row], attitudes.defect[row], settings.tolerance,
                         settings.sensitivity);
    }

    // NOLINTNEXTLINE(*-non-private-member-variables-in-classes): what it is for
    AttitudeBatch<double> attitudes; ///< rounded

private:
    /// Rows with a larger defect are looked at; below 0: all are.
    [[nodiscard]] static double largest_unreported(const ConversionSettings& settings) noexcept {
        return settings.sensitivity ? -1.0 : std::min(settings.tolerance, reported_defect);
    }
    /// Whether unusual_numbers() may find something: the sum of three squares is at least that of the largest, and
    /// angles in their usual ranges have a sum below 22.
    [[nodiscard]] bool is_unusual(std::size_t row) const noexcept {
        const double* const v = own_ + row * size_;
        const double square = (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];
        return size_ == 3 ? square > 39.0
                          : std::abs(square - 1.0) > 1.9 * reported_axis_defect || std::abs(v[3]) > reported_angle;
    }

    const Codec* codec_;
    const Spec* spec_;
    const double* own_;
    std::size_t size_;
    bool may_be_unusual_;
    std::array<double, batch_rows * most_numbers> own_order_;
};

/// Calls run(in, rows, out, first) for batches of rows of so many numbers; `first`: the first row of the batch.
/// @throw std::invalid_argument as checked_rows()
template <class Run> void for_each_batch(std::span<const double> in, std::size_t inputs, std::span<double> out,
                                         std::size_t outputs, const Run& run) {
    const std::size_t rows = checked_rows(in.size(), inputs, out.size(), outputs);
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run(in.data() + first * inputs, std::min(batch_rows, rows - first), out.data() + first * outputs, first);
    }
}

/// Appends the reports on rows of a batch whose results are in `out`; the numbers of a row with an error become nan.
/// @param all rows without an error or diagnostic are reported too
/// @param is_remarkable whether there may be something to report of a row
/// @param report_of its report, of what was read
/// @param complete adds to it what there is to report of the result
template <class IsRemarkable, class ReportOf, class Complete>
void report_rows(std::size_t first, std::size_t rows, double* out, std::size_t width, bool all,
                 std::vector<RowReport>& reports, const IsRemarkable& is_remarkable, const ReportOf& report_of,
                 const Complete& complete) {
    for (std::size_t i = 0; i < rows; ++i) {
        if (!is_remarkable(i)) {
            continue;
        }
        RowReport found = report_of(i);
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        } else {
            complete(i, found);
        }
        if (all || found.error != Error::none || !found.diagnostics.empty()) {
            found.row = first + i;
            reports.push_back(found);
        }
    }
}

/// The report on a row of two attitudes: the first error, or what there is to tell of both.
[[nodiscard]] RowReport report_of_pair(const InputBatch& first, const InputBatch& second, std::size_t row,
                                       const ConversionSettings& settings) noexcept;

/// Runs a task over rows of the numbers of its first SPEC, then those of its second one, or of a vector; lock margin
/// and fixed rotations are those of the settings. See Conversion::run() and again().
/// @param interpolates the second attitudes are between two, see Composition::interpolating()
void run_task(Task task, const ConversionSettings& settings, bool interpolates, std::span<const double> in,
              std::span<double> out, std::vector<RowReport>& reports, std::span<double> rest);

} // namespace rotconv
