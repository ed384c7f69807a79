#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <rotconv/conversion.hpp>

#include "representations/codec.hpp"

namespace rotconv {

/// Constant turns, as kernels take them.
[[nodiscard]] Turns turns_of(const std::optional<FixedRotation>& left,
                             const std::optional<FixedRotation>& right) noexcept;

/// A batch of rows of a SPEC and the attitudes that they describe, once a kernel has read them.
class InputBatch {
public:
    /// @param in as written, at most `batch_rows` rows, which must outlive this
    /// @param width numbers of a row, of which these are the first
    InputBatch(const Spec& spec, const double* in, std::size_t rows, std::size_t width) noexcept
        : codec_(&codec_of(spec.name)), own_(in), size_(spec.size()) {
        if (spec.is_reordered() || width != size_) {
            to_own_order(spec, in, rows, own_order_.data(), width);
            own_ = own_order_.data();
        }
    }

    /// The numbers in the representation's own order.
    [[nodiscard]] const double* own() const noexcept { return own_; }

    /// Rows with a larger defect are looked at; below 0: all are.
    [[nodiscard]] static double largest_unreported(const ConversionSettings& settings) noexcept {
        return settings.sensitivity ? -1.0 : std::min(settings.tolerance, reported_defect);
    }
    /// Whether report() may have something to tell of the row.
    [[nodiscard]] bool is_remarkable(std::size_t row, const ConversionSettings& settings) const noexcept {
        return attitudes.error[row] != Error::none || !(attitudes.defect[row] <= largest_unreported(settings));
    }
    /// The row's error, or its defect and whether that is to be reported.
    [[nodiscard]] RowReport report(std::size_t row, const ConversionSettings& settings) const noexcept {
        RowReport report{.error = attitudes.error[row]};
        if (report.error != Error::none) {
            return report;
        }
        report.defect = attitudes.defect[row];
        if (codec_->exact_defect != nullptr && (settings.sensitivity || settings.tolerance < report.defect)) {
            report.defect = codec_->exact_defect(own_ + row * size_);
        }
        if (report.defect > settings.tolerance) {
            report.error = Error::defect;
        } else {
            report.diagnostics = {DiagnosticKind::normalized, report.defect > reported_defect};
        }
        return report;
    }

    // NOLINTNEXTLINE(*-non-private-member-variables-in-classes): what it is for
    AttitudeBatch<double> attitudes; ///< rounded

private:
    const Codec* codec_;
    const double* own_;
    std::size_t size_;
    std::array<double, batch_rows * most_numbers> own_order_;
};

} // namespace rotconv
