#include "method_conversion.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include <Eigen/Core>

#include <rotconv/angle.hpp>

#include "../core/representations/codec.hpp"
#include "formulas.hpp"

namespace rotconv {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The numbers of the inverse rotation, of a representation that methods start from.
void invert(RepresentationId name, double* numbers) noexcept {
    if (name == RepresentationId::dcm) {
        Eigen::Map<formula::RowMajor>{numbers}.transposeInPlace();
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

/// The same turns, with any defect: what to refuse is for the conversion itself.
ConversionSettings turns_of(const ConversionSettings& settings) {
    return {.tolerance = any_defect, .left = settings.left, .right = settings.right};
}

std::vector<double> run(const Conversion& conversion, std::span<const double> in) {
    std::vector<double> out(in.size() / conversion.from().size() * conversion.to().size());
    std::vector<RowReport> reports;
    conversion.run(in, out, reports);
    return out;
}

/// Euler angles of the sequence without its signs become those of the SPEC.
void put_in_range(const Spec& to, double* angles) noexcept {
    const double half_turn = to.unit == AngleUnit::degrees ? 180.0 : std::numbers::pi;
    const bool is_other = to.sequence.proper() && to.sequence.sign(1) < 0.0; // a + pi, -b, c + pi, -b printed as b
    for (const std::size_t outer : {std::size_t{0}, std::size_t{2}}) {
        const double angle = to.sequence.sign(outer) * angles[outer] + (is_other ? half_turn : 0.0);
        const double turns = angle / (2.0 * half_turn);
        angles[outer] = angle - 2.0 * half_turn * (to.positive ? std::floor(turns) : std::ceil(turns - 0.5));
        if (to.positive && angles[outer] >= 2.0 * half_turn) { // by rounding
            angles[outer] = 0.0;
        }
    }
    angles[1] *= is_other ? 1.0 : to.sequence.sign(1);
}

} // namespace

MethodConversion::MethodConversion(const Conversion& own)
    : own_(own), turned_(own.settings().left || own.settings().right
                             ? std::optional(Conversion(own.from(), Spec{}, turns_of(own.settings())))
                             : std::nullopt),
      comparison_(turned_ ? Spec{} : own.from(), own.to(), {.reading = {.tolerance = any_defect}}) {}

MethodConversion::MethodConversion(const Conversion& own, const Method& method) : MethodConversion(own) {
    if (!method.serves(from().name, to().name) || method.run == nullptr) {
        throw std::invalid_argument("not a published method of this pair");
    }
    published_.push_back(&method);
}

MethodConversion MethodConversion::all(const Conversion& own) {
    MethodConversion conversion(own);
    ConversionSettings fast = own.settings();
    fast.fast = true;
    conversion.fast_.emplace(own.from(), own.to(), fast);
    for (const Method& method : methods_of(own.from().name, own.to().name)) {
        if (method.run != nullptr) {
            conversion.published_.push_back(&method);
        }
    }
    return conversion;
}

std::vector<std::string_view> MethodConversion::names() const {
    std::vector<std::string_view> names;
    if (fast_) {
        names = {default_method, fast_method};
    }
    std::ranges::transform(published_, std::back_inserter(names), &Method::name);
    return names;
}

void MethodConversion::run(std::span<const double> in, std::span<double> out, std::vector<double>& angles,
                           std::vector<RowReport>& reports) const {
    const std::size_t rows = in.size() / from().size();
    std::vector<double> own_numbers(rows * to().size());
    std::vector<RowReport> own;
    own_.run(in, own_numbers, own);

    std::vector<std::vector<double>> answers;
    if (fast_) {
        answers = {own_numbers, rotconv::run(*fast_, in)};
    }
    const auto numbers = published_.empty() ? std::vector<double>() : starting_numbers(in);
    for (const Method* method : published_) {
        answers.push_back(answers_of(*method, numbers));
    }
    const auto turned = turned_ ? rotconv::run(*turned_, in) : std::vector<double>();
    std::vector<std::vector<double>> found; // the angle of each answer
    for (const auto& answer : answers) {
        found.push_back(angles_of(turned_ ? std::span<const double>(turned) : in, answer));
    }

    angles.assign(rows * answers.size(), not_a_number);
    reports.clear();
    for (std::size_t i = 0, next = 0; i < rows; ++i) {
        const bool is_reported = next < own.size() && own[next].row == i;
        const RowReport of_row = is_reported ? own[next++] : RowReport{};
        const bool is_infinite = of_row.diagnostics.has(DiagnosticKind::infinite);
        const auto numbers_of = [&, size = to().size()](std::span<const double> all) {
            return all.subspan(i * size, size);
        };
        for (std::size_t a = 0; a < answers.size(); ++a) {
            const std::size_t at = i * answers.size() + a;
            const auto written = out.subspan(at * to().size(), to().size());
            RowReport report = of_row;
            report.row = at;
            if (report.error != Error::none) {
                std::ranges::fill(written, not_a_number);
            } else {
                std::ranges::copy(numbers_of(answers[a]), written.begin());
                angles[at] = is_infinite && std::ranges::equal(written, numbers_of(own_numbers)) ? 0.0 : found[a][i];
                report.diagnostics |= {DiagnosticKind::method_error, !(angles[at] <= reported_method_error)};
            }
            report.deviation = angles[at];
            if (is_reported || !report.diagnostics.empty()) {
                reports.push_back(report);
            }
        }
    }
}

std::vector<double> MethodConversion::starting_numbers(std::span<const double> in) const {
    const bool is_inverted = from().passive != to().passive;
    // Of what has been turned no numbers are given, and two columns alone do not tell those of the inverse.
    if (turned_ || (is_inverted && from().name == RepresentationId::two_column)) {
        return rotconv::run({from(), {.name = from().name, .passive = to().passive}, turns_of(own_.settings())}, in);
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

std::vector<double> MethodConversion::answers_of(const Method& method, std::span<const double> numbers) const {
    const std::size_t rows = numbers.size() / from().size();
    std::vector<double> own(rows * to().size());
    method.run(to().sequence, numbers.data(), rows, own.data());
    if (to().unit == AngleUnit::degrees) {
        std::ranges::for_each(own, [](double& v) { v *= degrees_per_radian; });
    }
    for (std::size_t i = 0; i < own.size(); i += to().size()) {
        if (to().sequence.has_signs() || to().positive) {
            put_in_range(to(), own.data() + i);
        } else if (to().name == RepresentationId::quat) {
            make_sign_canonical(own.data() + i);
        }
    }
    std::vector<double> written(own.size());
    to_written_order(to(), own.data(), rows, written.data());
    return written;
}

std::vector<double> MethodConversion::angles_of(std::span<const double> attitudes,
                                                std::span<const double> answers) const {
    const std::size_t size = to().size();
    const std::size_t rows = answers.size() / size;
    const std::size_t attitude_size = comparison_.from().size();
    std::vector<double> pairs;
    pairs.reserve(attitudes.size() + answers.size());
    for (std::size_t i = 0; i < rows; ++i) {
        const auto attitude = attitudes.subspan(attitude_size * i, attitude_size);
        const auto answer = answers.subspan(size * i, size);
        pairs.insert(pairs.end(), attitude.begin(), attitude.end());
        pairs.insert(pairs.end(), answer.begin(), answer.end());
    }
    std::vector<double> angles(rows);
    std::vector<RowReport> reports;
    comparison_.run(pairs, angles, reports);
    return angles;
}

} // namespace rotconv
