#include <rotconv/conversion.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "checks.hpp"
#include "numerics/elementary.hpp"
#include "numerics/power_of_two.hpp"
#include "representations/codec.hpp"

namespace rotconv {

double last_place(std::span<const double> numbers, double enough) noexcept {
    double largest = 0.0;
    for (const double number : numbers) {
        if (!std::isfinite(number)) {
            return 0.0;
        }
        largest = std::max(largest, std::abs(number));
    }
    double power = 1.0; // ten to the number of decimal places, exact to 1e22
    int places = 0;
    for (const double number : numbers) {
        if (std::abs(number) < 0.5 * largest) {
            continue;
        }
        std::array<char, 32> text{}; // d.ddde-xx, with the fewest digits
        const char* const begin = text.data();
        const char* const end =
            std::to_chars(text.data(), text.data() + text.size(), std::abs(number), std::chars_format::scientific).ptr;
        const char* const mark = std::find(begin, end, 'e');
        int exponent = 0;
        std::from_chars(mark + (mark[1] == '+' ? 2 : 1), end, exponent);
        const int given = static_cast<int>(mark - begin > 1 ? mark - begin - 2 : 0) - exponent;
        if (number == 0.0 || given <= 0) {
            return 0.0;
        }
        for (; places < given; ++places) {
            power *= 10.0;
        }
        if (1.0 / power <= enough) {
            break;
        }
    }
    return 1.0 / power;
}

double attitude_error(const Spec& spec, std::span<const double> numbers, double error) {
    check_size(numbers.size(), spec.size());
    const auto turn_per_error = codec_of(spec.name).turn_per_error;
    return (turn_per_error == nullptr ? unit_in_radians(spec.unit).hi : turn_per_error(numbers.data())) * error;
}

UnusualNumbers unusual_numbers(const Spec& spec, std::span<const double> numbers, double defect, bool decimal) {
    check_size(numbers.size(), spec.size());
    UnusualNumbers found;
    if (defect > reported_defect &&
        !(decimal && defect <= 2.0 * last_place(numbers.first(spec.size()), 0.25 * defect))) {
        found.defect = defect;
    }
    const Representation& read = representation(spec.name);
    if (!read.has_angles()) {
        return found;
    }
    const bool has_axis = read.first_angle > 0;
    const double largest = largest_magnitude(numbers[0], numbers[1], numbers[2]);
    const double length = norm_of(numbers[0], numbers[1], numbers[2]);
    const double angle = has_axis                                ? std::abs(numbers[read.first_angle])
                         : spec.name == RepresentationId::rotvec ? length
                                                                 : largest;
    if (has_axis && length > 0.0 && std::abs(length - 1.0) > reported_axis_defect) {
        found.defect = std::abs(length - 1.0);
        found.of_axis = true;
    }
    if (spec.unit == AngleUnit::radians && angle > reported_angle) {
        found.angle = angle;
    }
    return found;
}

} // namespace rotconv
