#include "method_conversion.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include <Eigen/Core>

#include <rotconv/angle.hpp>
#include <rotconv/comparison.hpp>

#include "../core/conversion/input_batch.hpp"
#include "../core/representations/euler_formulas.hpp"
#include "formulas.hpp"

namespace rotconv {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Inverts a rotation in a representation that methods start from.
void invert(RepresentationId name, double* numbers) noexcept {
    if (name == RepresentationId::dcm) {
        Eigen::Map<formula::RowMajor>{numbers}.transposeInPlace();
        return;
    }
    const std::size_t first = name == RepresentationId::quat ? 1 : 0; // index of the vector
    std::transform(numbers + first, numbers + first + 3, numbers + first, std::negate<>());
}

/// Gives a quaternion the sign with which quaternions are printed.
void make_sign_canonical(double* q) noexcept {
    const double* const leader = std::find_if(q, q + 4, [](double component) { return component != 0.0; });
    if (leader != q + 4 && *leader < 0.0) { // Rotation::sign() would look at the sign of a nan
        std::transform(q, q + 4, q, std::negate<>());
    }
}

/// The change by --left and --right alone, with any defect: the conversion itself refuses rows.
ConversionSettings change_of(const ConversionSettings& settings) {
    return {.tolerance = any_defect, .left = settings.left, .right = settings.right};
}

std::vector<double> run(const Conversion& conversion, std::span<const double> in) {
    std::vector<double> out(in.size() / conversion.from().size() * conversion.to().size());
    std::vector<RowReport> reports;
    conversion.run(in, out, reports);
    return out;
}

/// Converts Euler angles of the sequence without its signs to those of the SPEC.
void put_in_range(const Spec& to, double* angles) noexcept {
    const AngleRanges ranges(FixedAxes(to.sequence), to);
    const double half_turn = ranges.half_turn.hi;
    for (const std::size_t outer : {std::size_t{0}, std::size_t{2}}) {
        const double angle = to.sequence.sign(outer) * angles[outer] + (ranges.is_other ? half_turn : 0.0);
        angles[outer] = ranges.outer(angle > half_turn ? angle - 2.0 * half_turn : angle);
        angles[outer] = to.positive ? ranges.positive(angles[outer]) : angles[outer];
    }
    angles[1] *= ranges.is_other ? 1.0 : to.sequence.sign(1);
}

} // namespace

MethodConversion::MethodConversion(const Conversion& own, std::string_view name, const Method* method)
    : own_(own), name_(name), method_(method) {
    if (!own.settings().left.is_identity() || !own.settings().right.is_identity()) {
        rotated_.emplace(own.from(), Spec{}, change_of(own.settings()));
    }
}

MethodConversion::MethodConversion(const Conversion& own, const Method& method)
    : MethodConversion(own, method.name, &method) {
    if (!method.serves(from().name, to().name)) {
        throw std::invalid_argument("not a published method of this pair");
    }
}

std::vector<MethodConversion> MethodConversion::all(const Conversion& own) {
    std::vector<MethodConversion> all{{own, default_method, nullptr}, {own, fast_method, nullptr}};
    ConversionSettings fast = own.settings();
    fast.fast = true;
    all.back().fast_.emplace(own.from(), own.to(), fast);
    for (const Method& method : methods_of(own.from().name, own.to().name)) {
        all.emplace_back(own, method);
    }
    return all;
}

void MethodConversion::run(std::span<const double> in, std::span<double> out, std::vector<double>& angles,
                           std::vector<RowReport>& reports) const {
    const std::size_t size = to().size();
    const std::size_t rows = in.size() / from().size();
    std::vector<double> numbers(rows * size);
    std::vector<RowReport> own;
    if (fast_) {
        fast_->run(in, out, own);
    }
    own_.run(in, numbers, own);
    if (method_ != nullptr) {
        run_method(in, out);
    } else if (!fast_) {
        std::ranges::copy(numbers, out.begin());
    }
    measure(rotated_ ? rotconv::run(*rotated_, in) : std::vector(in.begin(), in.end()), out, angles);

    reports.clear();
    for (std::size_t i = 0, next = 0; i < rows; ++i) {
        const bool is_reported = next < own.size() && own[next].row == i;
        RowReport report = is_reported ? own[next++] : RowReport{.row = i};
        double* const written = out.data() + i * size;
        if (report.error != Error::none) {
            std::fill_n(written, size, not_a_number);
            angles[i] = not_a_number;
        } else if (report.diagnostics.has(DiagnosticKind::infinite) &&
                   std::equal(written, written + size, numbers.data() + i * size)) {
            angles[i] = 0.0;
        }
        report.deviation = angles[i];
        const bool is_wrong = report.error == Error::none && !(report.deviation <= reported_method_error);
        if (is_reported || is_wrong) {
            report.diagnostics |= {DiagnosticKind::method_error, is_wrong};
            reports.push_back(report);
        }
    }
}

std::vector<double> MethodConversion::starting_numbers(std::span<const double> in) const {
    const bool is_inverted = from().passive != to().passive;
    // An attitude that was changed by --left or --right has no input numbers, nor has the inverse of two columns.
    if (rotated_ || (is_inverted && from().name == RepresentationId::two_column)) {
        return rotconv::run({from(), {.name = from().name, .passive = to().passive}, change_of(own_.settings())}, in);
    }
    std::vector<double> numbers(in.size());
    to_own_order(from(), in.data(), in.size() / from().size(), numbers.data());
    if (is_inverted) {
        for (std::size_t i = 0; i < numbers.size(); i += from().size()) {
            invert(from().name, numbers.data() + i);
        }
    }
    if (from().unit == AngleUnit::degrees) {
        std::ranges::for_each(numbers, [](double& v) { v *= radians_per_degree; });
    }
    return numbers;
}

void MethodConversion::run_method(std::span<const double> in, std::span<double> out) const {
    const auto numbers = starting_numbers(in);
    const std::size_t rows = in.size() / from().size();
    std::vector<double> answers(out.size());
    method_->run(to().sequence, numbers.data(), rows, answers.data());
    if (to().unit == AngleUnit::degrees) {
        std::ranges::for_each(answers, [](double& v) { v *= degrees_per_radian; });
    }
    for (std::size_t i = 0; i < answers.size(); i += to().size()) {
        if (to().sequence.has_signs() || to().positive) {
            put_in_range(to(), answers.data() + i);
        } else if (to().name == RepresentationId::quat) {
            make_sign_canonical(answers.data() + i);
        }
    }
    to_written_order(to(), answers.data(), rows, out.data());
}

void MethodConversion::measure(std::span<const double> attitudes, std::span<const double> answers,
                               std::vector<double>& angles) const {
    const Comparison comparison(rotated_ ? Spec{} : from(), to(), {.reading = {.tolerance = any_defect}});
    const std::size_t first = comparison.from().size();
    const std::size_t second = to().size();
    angles.resize(answers.size() / second);
    std::vector<double> pairs(angles.size() * (first + second));
    for (std::size_t i = 0; i < angles.size(); ++i) {
        double* const pair = pairs.data() + i * (first + second);
        std::copy_n(attitudes.data() + i * first, first, pair);
        std::copy_n(answers.data() + i * second, second, pair + first);
    }
    std::vector<RowReport> reports;
    comparison.run(pairs, angles, reports);
}

} // namespace rotconv
