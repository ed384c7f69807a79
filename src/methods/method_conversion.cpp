#include "method_conversion.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <stdexcept>

#include <Eigen/Core>

#include <rotconv/angle.hpp>

#include "../core/conversion/input_batch.hpp"
#include "../core/conversion/kernels.hpp"
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
    const double half_turn = to.unit == AngleUnit::degrees ? 180.0 : std::numbers::pi;
    const bool is_second_triple = to.sequence.proper() && to.sequence.sign(1) < 0.0; // a + pi, -b, c + pi
    for (const std::size_t outer : {std::size_t{0}, std::size_t{2}}) {
        const double angle = to.sequence.sign(outer) * angles[outer] + (is_second_triple ? half_turn : 0.0);
        const double full_turns = angle / (2.0 * half_turn);
        angles[outer] = angle - 2.0 * half_turn * (to.positive ? std::floor(full_turns) : std::ceil(full_turns - 0.5));
        if (to.positive && angles[outer] >= 2.0 * half_turn) { // by rounding
            angles[outer] = 0.0;
        }
    }
    angles[1] *= is_second_triple ? 1.0 : to.sequence.sign(1);
}

} // namespace

MethodConversion::MethodConversion(const Conversion& own)
    : own_(own), rotated_(own.settings().left.is_identity() && own.settings().right.is_identity()
                              ? std::nullopt
                              : std::optional(Conversion(own.from(), Spec{}, change_of(own.settings())))) {}

MethodConversion::MethodConversion(const Conversion& own, const Method& method) : MethodConversion(own) {
    if (!method.serves(from().name, to().name)) {
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
        conversion.published_.push_back(&method);
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
    const std::size_t size = to().size();
    const std::size_t rows = in.size() / from().size();
    const std::size_t count = published_.size() + (fast_ ? 2 : 0);
    // The numbers of own_, of fast_ and of each method, and room for one more; not set at first.
    Eigen::ArrayXd numbers(static_cast<Eigen::Index>((published_.size() + 3) * rows * size));
    const auto numbers_of = [&](std::size_t i) { return std::span(numbers.data() + i * rows * size, rows * size); };
    std::vector<RowReport> own;
    if (fast_) {
        fast_->run(in, numbers_of(1), own);
    }
    own_.run(in, numbers_of(0), own);
    if (!published_.empty()) {
        const auto starting = starting_numbers(in);
        for (std::size_t i = 0; i < published_.size(); ++i) {
            run_method(*published_[i], starting, numbers_of(2 + published_.size()), numbers_of(2 + i));
        }
    }
    const std::span<const double> answers(numbers_of(fast_ ? 0 : 2).data(), count * rows * size);
    angles.resize(rows * count);
    const auto rotated = rotated_ ? rotconv::run(*rotated_, in) : std::vector<double>();
    measure(rotated_ ? rotated : in, answers, count, angles);

    reports.clear();
    for (std::size_t i = 0, next = 0; i < rows; ++i) {
        const bool is_reported = next < own.size() && own[next].row == i;
        RowReport report = is_reported ? own[next++] : RowReport{.row = i};
        for (std::size_t at = i * count; at < (i + 1) * count; ++at) {
            double* const written = out.data() + at * size;
            if (report.error != Error::none) {
                std::fill_n(written, size, not_a_number);
                angles[at] = not_a_number;
            } else {
                std::copy_n(answers.data() + ((at - i * count) * rows + i) * size, size, written);
                if (report.diagnostics.has(DiagnosticKind::infinite) &&
                    std::equal(written, written + size, numbers.data() + i * size)) {
                    angles[at] = 0.0;
                }
            }
            if (!(angles[at] <= report.deviation)) { // or nan, which stays
                report.deviation = std::isnan(report.deviation) ? not_a_number : angles[at];
            }
        }
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

void MethodConversion::run_method(const Method& method, std::span<const double> numbers, std::span<double> room,
                                  std::span<double> written) const {
    const std::size_t rows = numbers.size() / from().size();
    method.run(to().sequence, numbers.data(), rows, room.data());
    if (to().unit == AngleUnit::degrees) {
        std::ranges::for_each(room, [](double& v) { v *= degrees_per_radian; });
    }
    for (std::size_t i = 0; i < room.size(); i += to().size()) {
        if (to().sequence.has_signs() || to().positive) {
            put_in_range(to(), room.data() + i);
        } else if (to().name == RepresentationId::quat) {
            make_sign_canonical(room.data() + i);
        }
    }
    to_written_order(to(), room.data(), rows, written.data());
}

void MethodConversion::measure(std::span<const double> attitudes, std::span<const double> answers, std::size_t count,
                               std::span<double> angles) const {
    const KernelTable& kernels = kernel_table();
    const Spec spec = rotated_ ? Spec{} : from();
    const std::size_t all = attitudes.size() / spec.size();
    AttitudeBatch<double> relative;
    std::array<double, batch_rows> sizes;
    for (std::size_t first = 0; first < all; first += batch_rows) {
        const std::size_t rows = std::min(batch_rows, all - first);
        InputBatch attitude(spec, attitudes.data() + first * spec.size(), rows, spec.size());
        kernels.read(spec, no_rotations, attitude.own(), rows, attitude.attitudes);
        for (std::size_t a = 0; a < count; ++a) {
            InputBatch answer(to(), answers.data() + (a * all + first) * to().size(), rows, to().size());
            kernels.read(to(), no_rotations, answer.own(), rows, answer.attitudes);
            relate(attitude.attitudes, answer.attitudes, rows, relative, sizes.data());
            for (std::size_t i = 0; i < rows; ++i) {
                angles[(first + i) * count + a] = relative.error[i] == Error::none ? sizes[i] : not_a_number;
            }
        }
    }
}

} // namespace rotconv
