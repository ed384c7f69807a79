#include "method_conversion.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>

#include <rotconv/angle.hpp>

#include "../core/representations/codec.hpp"
#include "../core/representations/half_turn.hpp"
#include "formulas.hpp"

namespace rotconv {
namespace {

/// The numbers of the inverse rotation, of a representation that methods start from.
void invert(RepresentationId name, double* numbers) noexcept {
    if (name == RepresentationId::dcm) {
        Eigen::Map<RowMajor>{numbers}.transposeInPlace();
        return;
    }
    const std::size_t first = name == RepresentationId::quat ? 1 : 0; // of the vector
    std::transform(numbers + first, numbers + first + 3, numbers + first, std::negate<>());
}

/// The sign of a quaternion that is printed.
void make_sign_canonical(double* q) noexcept {
    const double* const leader = std::find_if(q, q + 4, [](double component) { return component != 0.0; });
    if (leader != q + 4 && *leader < 0.0) {
        std::transform(q, q + 4, q, std::negate<>());
    }
}

} // namespace

MethodConversion::MethodConversion(const Conversion& own, const Method& method)
    : own_(own), method_(&method), turns_(own.settings(), own.from().passive) {
    if (!method.serves(from().name, to().name) || method.run == nullptr) {
        throw std::invalid_argument("not a published method of this pair");
    }
}

void MethodConversion::run(std::span<const double> in, std::span<double> out, std::vector<Report>& reports) const {
    std::vector<Report> own;
    own_.run(in, out, own);
    reports.clear();
    auto next = own.cbegin();
    const std::size_t rows = in.size() / from().size();
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        const std::size_t some = std::min(batch_rows, rows - first);
        const auto end =
            std::find_if(next, own.cend(), [&](const Report& report) { return report.row >= first + some; });
        run_batch(in.data() + first * from().size(), first, some, out.data() + first * to().size(), {next, end},
                  reports);
        next = end;
    }
}

void MethodConversion::run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                                 std::span<const Report> own, std::vector<Report>& reports) const {
    const std::size_t in_size = from().size();
    const std::size_t out_size = to().size();
    const bool inverse = from().passive != to().passive;

    // What the methods do not know of is done to the numbers: order, the inverse, and degrees.
    std::array<double, batch_rows * most_numbers> numbers; // NOLINT(*-member-init): written before it is read
    to_own_order(from(), in, rows, numbers.data());
    Readings attitudes; // NOLINT(*-member-init)
    batch_functions().read(from(), numbers.data(), rows, attitudes);
    if (turns_.any()) { // the methods start from numbers
        turns_.turn(attitudes, rows);
        std::array<DiagnosticSet, batch_rows> diagnostics; // NOLINT(*-member-init)
        batch_functions().write(from(), 0.0, attitudes, rows, numbers.data(), diagnostics.data());
    }
    if (inverse) {
        for (std::size_t i = 0; i < rows; ++i) {
            invert(from().name, numbers.data() + i * in_size);
        }
    }
    if (from().unit == AngleUnit::degrees) {
        std::for_each_n(numbers.begin(), rows * in_size, [](double& v) { v *= radians_per_degree; });
    }

    std::array<double, batch_rows * most_numbers> answers; // NOLINT(*-member-init): written before it is read
    method_->run(to().sequence, numbers.data(), rows, answers.data());
    if (to().unit == AngleUnit::degrees) {
        std::for_each_n(answers.begin(), rows * out_size, [](double& v) { v *= degrees_per_radian; });
    }
    Readings answered; // NOLINT(*-member-init)
    batch_functions().read(to(), answers.data(), rows, answered);

    for (std::size_t i = 0; i < rows; ++i) {
        Report report{.row = first + i};
        const bool reported = !own.empty() && own.front().row == report.row;
        if (reported) {
            report = own.front();
            own = own.subspan(1);
        }
        if (report.error != Error::none) {
            reports.push_back(report);
            continue;
        }
        if (!report.diagnostics.has(DiagnosticKind::infinite)) { // else no finite number is nearer
            const Rotation attitude = inverse ? attitudes.at(i).inverse() : attitudes.at(i);
            report.deviation = answered.error[i] == Error::none ? angle_of(attitude.inverse() * answered.at(i))
                                                                : std::numeric_limits<double>::quiet_NaN();
            report.diagnostics |= {DiagnosticKind::method_error, !(report.deviation <= reported_method_error)};
        }
        if (reported || !report.diagnostics.empty()) {
            reports.push_back(report);
        }
        double* const answer = answers.data() + i * out_size;
        if (to().name == RepresentationId::quat) {
            make_sign_canonical(answer);
        }
        to_written_order(to(), answer, 1, out + i * out_size);
    }
}

} // namespace rotconv
