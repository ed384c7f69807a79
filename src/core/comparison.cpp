#include <rotconv/comparison.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "batch.hpp"
#include "numerics/products.hpp"
#include "read_batch.hpp"
#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

/// R_REF' R, or R R_REF'. The factors stand in such an order that equal quaternions have a vector part of 0, subnormal
/// numbers included.
ROTCONV_TARGET_CLONES
void relative_rotations(const Rotations& a, const Rotations& ref, Frame frame, std::size_t rows,
                        Rotations& relative) noexcept {
    const double side = frame == Frame::body ? 1.0 : -1.0;
    for (std::size_t i = 0; i < rows; ++i) {
        const double w = a.w[i];
        const double x = a.x[i];
        const double y = a.y[i];
        const double z = a.z[i];
        const double rw = ref.w[i];
        relative.w[i] = sum_of_products(rw, w, ref.x[i], x, ref.y[i], y, ref.z[i], z);
        const double rx = side * ref.x[i];
        const double ry = side * ref.y[i];
        const double rz = side * ref.z[i];
        relative.x[i] = sum_of_products(rw, x, -w, ref.x[i], rz, y, -z, ry);
        relative.y[i] = sum_of_products(rw, y, -w, ref.y[i], rx, z, -x, rz);
        relative.z[i] = sum_of_products(rw, z, -w, ref.z[i], ry, x, -y, rx);
    }
}

/// Takes numbers `begin` to `begin + count` of each row together.
std::array<double, batch_rows * most_numbers> part_of(const double* rows_of, std::size_t width, std::size_t begin,
                                                      std::size_t count, std::size_t rows) noexcept {
    std::array<double, batch_rows * most_numbers> part; // as many as there are
    for (std::size_t i = 0; i < rows; ++i) {
        std::copy_n(rows_of + i * width + begin, count, part.data() + i * count);
    }
    return part;
}

/// The attitudes to 106 bits, and then rounded: plain readings may be 3 eps off. The numbers that they are written in
/// are for nobody.
void read_rounded(const Spec& spec, ReadBatch& attitudes, std::size_t rows) noexcept {
    static constexpr Spec quat{};
    std::array<double, 4 * batch_rows> numbers;
    std::array<DiagnosticSet, batch_rows> diagnostics;
    batch_functions().convert({&spec, &quat, 0.0, nullptr, nullptr}, attitudes.own(), rows, attitudes, numbers.data(),
                              diagnostics.data());
}

/// What is to be told of a row, of both its attitudes.
Report report_of(const ReadBatch& attitudes, const ReadBatch& references, std::size_t row, const Settings& settings) {
    Report report = attitudes.report(row, settings);
    if (report.error != Error::none) {
        return report;
    }
    Report other = references.report(row, settings);
    if (other.error != Error::none) {
        other.of_reference = true;
        return other;
    }
    report.diagnostics |= other.diagnostics;
    report.reference_defect = other.defect;
    return report;
}

} // namespace

Comparison::Comparison(const Spec& from, const Spec& reference, const ComparisonSettings& settings)
    : from_(from), reference_(reference), settings_(settings) {}

std::size_t Comparison::outputs() const noexcept { return 1 + (settings_.relative ? settings_.relative->size() : 0); }

void Comparison::run(std::span<const double> in, std::span<double> out, std::vector<Report>& reports) const {
    reports.clear();
    const std::size_t rows = in.size() / inputs();
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        run_batch(in.data() + first * inputs(), first, std::min(batch_rows, rows - first),
                  out.data() + first * outputs(), reports);
    }
}

void Comparison::run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                           std::vector<Report>& reports) const {
    const auto numbers = part_of(in, inputs(), 0, from_.size(), rows);
    const auto other_numbers = part_of(in, inputs(), from_.size(), reference_.size(), rows);
    ReadBatch attitudes(from_, numbers.data(), rows);
    ReadBatch references(reference_, other_numbers.data(), rows);
    read_rounded(from_, attitudes, rows);
    read_rounded(reference_, references, rows);
    Rotations relative;
    relative_rotations(attitudes, references, settings_.frame, rows, relative);

    const double unit = settings_.unit == AngleUnit::degrees ? degrees_per_radian : 1.0;
    const std::size_t width = outputs();
    for (std::size_t i = 0; i < rows; ++i) {
        out[i * width] = unit * angle_of(relative.at(i));
    }
    std::array<DiagnosticSet, batch_rows> diagnostics{};
    if (settings_.relative) {
        write_relative(attitudes.own(), references.own(), rows, out, diagnostics.data());
    }
    for (std::size_t i = 0; i < rows; ++i) {
        Report found = report_of(attitudes, references, i, settings_.reading);
        if (found.error != Error::none) {
            std::fill_n(out + i * width, width, std::numeric_limits<double>::quiet_NaN());
        } else {
            found.deviation = out[i * width];
            found.diagnostics |= diagnostics[i];
            found.diagnostics |= {DiagnosticKind::beyond, found.deviation > settings_.within};
            if (!settings_.reading.sensitivity && found.diagnostics.empty()) {
                continue;
            }
            if (settings_.relative) {
                const Spec& to = *settings_.relative;
                found.sensitivity =
                    codec_of(to.name).sensitivity(to, to.passive ? relative.at(i).inverse() : relative.at(i));
            }
        }
        found.row = first + i;
        reports.push_back(found);
    }
}

void Comparison::write_relative(const double* attitudes, const double* references, std::size_t rows, double* out,
                                DiagnosticSet* diagnostics) const noexcept {
    const Spec& to = *settings_.relative;
    std::array<double, batch_rows * most_numbers> own;
    std::array<double, batch_rows * most_numbers> written;
    batch_functions().relate({&from_, &reference_, &to, settings_.frame, settings_.reading.lock_margin}, attitudes,
                             references, rows, own.data(), diagnostics);
    to_written_order(to, own.data(), rows, written.data());
    for (std::size_t i = 0; i < rows; ++i) {
        std::copy_n(written.data() + i * to.size(), to.size(), out + i * outputs() + 1);
    }
}

} // namespace rotconv
