#include "rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "oracle.hpp"

namespace accuracy {
namespace {

using rotconv::Spec;

/// A quaternion that is unit to 4 eps keeps its bits.
bool keeps_bits(const Spec& from, const Spec& to, std::span<const double> row) {
    if (from.name != rotconv::RepresentationId::quat || to.name != rotconv::RepresentationId::quat) {
        return false;
    }
    oracle::Real square = 0;
    for (const double component : row) {
        square += oracle::Real(component) * component;
    }
    return abs(sqrt(square) - 1) <= oracle::Real(4.001 * oracle::eps);
}

/// K of the promise: how much more the relative error of a number is than that of the attitude, by the condition and by
/// cancellation.
double enlargement(const Spec& from, const Spec& to, std::span<const double> row, double condition, double number) {
    const auto in_radians = [](const Spec& spec) {
        return spec.unit == rotconv::AngleUnit::degrees ? 0.017453292519943295 : 1.0;
    };
    double cancelled = 1.0;
    if (!rotconv::representation(from.name).has_gimbal_lock) {
        const auto attitude = *rotconv::read_attitude(from, row); // which need not be unit
        cancelled = attitude.vector_length() / std::sqrt(attitude.squared_norm());
    }
    if (from.name == rotconv::RepresentationId::rotvec) {
        const double length = std::hypot(row[0], row[1], row[2]) * in_radians(from);
        cancelled = length > 3.141592653589793 ? std::max(cancelled, length / 64.0) : cancelled;
    }
    return std::max(1.0, condition) * std::max(1.0, cancelled / std::fabs(number * in_radians(to)));
}

/// Nearer to w = 0 than such decisions are promised: either sign may come out.
bool is_half_turn(const Spec& from, std::span<const double> row) {
    return abs(oracle::attitude(from, row).w()) < oracle::Real(0x1p-90);
}

double ulp_of(double number) {
    return std::nextafter(std::fabs(number), std::numeric_limits<double>::infinity()) - std::fabs(number);
}

} // namespace

Rounding& Rounding::operator+=(const Rounding& other) noexcept {
    rows += other.rows;
    numbers += other.numbers;
    wrong += other.wrong;
    beyond += other.beyond;
    uncertain += other.uncertain;
    return *this;
}

Rounding rounding_of(const Spec& from, const Spec& to, const std::vector<std::vector<double>>& rows) {
    const rotconv::Conversion conversion(from, to,
                                         {.tolerance = std::numeric_limits<double>::infinity(), .sensitivity = true});
    Rounding count;
    std::vector<double> result(to.size());
    std::vector<rotconv::RowReport> reports;
    for (const auto& row : rows) {
        conversion.run(row, result, reports);
        if (reports.at(0).error != rotconv::Error::none) {
            continue;
        }
        if (keeps_bits(from, to, row)) {
            continue;
        }
        ++count.rows;
        const auto exact = oracle::converted(from, to, row);
        for (std::size_t i = 0; i < result.size(); ++i) {
            ++count.numbers;
            if (!exact[i].certain) {
                ++count.uncertain;
            } else if (std::bit_cast<std::uint64_t>(exact[i].value) != std::bit_cast<std::uint64_t>(result[i])) {
                const double enlarged = enlargement(from, to, row, reports[0].sensitivity.condition, exact[i].value);
                const double off = std::fabs((result[i] - exact[i].value) - exact[i].rest) / ulp_of(exact[i].value);
                if (off <= 0.5 + 0x1p-45 * enlarged || (result[i] == -exact[i].value && is_half_turn(from, row))) {
                    ++count.beyond;
                    continue;
                }
                ++count.wrong;
                if (count.wrong <= 3) {
                    std::printf("   number %zu:%s: %.17g for %.17g\n", i + 1, text_of(row).c_str(), result[i],
                                exact[i].value);
                }
            }
        }
    }
    return count;
}

Rounding rounding_of(const std::string& from_text, const std::string& to_text, int size) {
    const Spec from = spec(from_text);
    const Spec to = spec(to_text);
    return rounding_of(from, to, inputs(from, to, size));
}

const std::vector<std::string>& compared_specs() {
    static const std::vector<std::string> all{
        "quat", "dcm", "6d", "5d", "cayley", "rotvec", "rotvec:deg", "axis-angle:deg", "mrp", "rpy:deg", "euler:zxz"};
    return all;
}

} // namespace accuracy
