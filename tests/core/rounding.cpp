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

} // namespace

Rounding& Rounding::operator+=(const Rounding& other) noexcept {
    rows += other.rows;
    numbers += other.numbers;
    wrong += other.wrong;
    uncertain += other.uncertain;
    return *this;
}

Rounding rounding_of(const Spec& from, const Spec& to, const std::vector<std::vector<double>>& rows) {
    const rotconv::Conversion conversion(from, to, {.tolerance = std::numeric_limits<double>::infinity()});
    Rounding count;
    std::vector<double> result(to.size());
    std::vector<rotconv::RowReport> reports;
    for (const auto& row : rows) {
        conversion.run(row, result, reports);
        if (!reports.empty() && reports[0].error != rotconv::Error::none) {
            continue;
        }
        if (keeps_bits(from, to, row)) {
            continue;
        }
        ++count.rows;
        const auto exact = oracle::converted(from, to, row);
        for (std::size_t i = 0; i < result.size(); ++i) {
            ++count.numbers;
            const bool is_zero = !exact[i].certain && exact[i].value == 0.0; // to 10^-300 in 750 digits
            if (!exact[i].certain && !is_zero) {
                ++count.uncertain;
            } else if (std::bit_cast<std::uint64_t>(exact[i].value) != std::bit_cast<std::uint64_t>(result[i])) {
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
