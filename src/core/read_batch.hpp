#pragma once

#include <array>
#include <cstddef>

#include <rotconv/conversion.hpp>

#include "representations/codec.hpp"

namespace rotconv {

/// A batch of rows of a SPEC, to be read: its attitudes, not yet inverted where the SPEC is passive.
class ReadBatch : public Readings {
public:
    /// @param in as written, at most `batch_rows` rows, which must outlive this
    ReadBatch(const Spec& spec, const double* in, std::size_t rows) noexcept
        : codec_(&codec_of(spec.name)), own_(in), size_(spec.size()) {
        if (spec.is_reordered()) {
            to_own_order(spec, in, rows, own_order_.data());
            own_ = own_order_.data();
        }
    }

    /// The numbers in the representation's own order.
    [[nodiscard]] const double* own() const noexcept { return own_; }

    void read(const Spec& spec, std::size_t rows) noexcept { batch_functions().read(spec, own_, rows, *this); }

    /// The inverses.
    void invert(std::size_t rows) noexcept {
        for (std::size_t i = 0; i < rows; ++i) {
            w[i] = -w[i];
        }
    }

    /// The row's error, or its defect and whether that is to be told.
    [[nodiscard]] Report report(std::size_t row, const Settings& settings) const noexcept {
        const Reading read = reading(row);
        Report report{.error = read.error(), .defect = read.defect()};
        if (!read) {
            return report;
        }
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

private:
    const Codec* codec_;
    const double* own_;
    std::size_t size_;
    std::array<double, batch_rows * most_numbers> own_order_;
};

} // namespace rotconv
