#include "checks.hpp"

#include <stdexcept>
#include <string>

namespace rotconv {

void check_size(std::size_t given, std::size_t needed) {
    if (given < needed) {
        throw std::invalid_argument("rotconv: a span has " + std::to_string(given) + " numbers, " +
                                    std::to_string(needed) + " are needed");
    }
}

std::size_t checked_rows(std::size_t numbers, std::size_t width, std::size_t room, std::size_t out_width) {
    if (numbers % width != 0) {
        throw std::invalid_argument("rotconv: " + std::to_string(numbers) + " numbers are not whole rows of " +
                                    std::to_string(width));
    }
    check_size(room, numbers / width * out_width);
    return numbers / width;
}

const Spec& checked(const Spec& spec) {
    if (!representation(spec.name).modifiers.has_all(spec.modifiers())) {
        throw std::invalid_argument("rotconv: " + spec.text() + " has a modifier without a meaning");
    }
    return spec;
}

} // namespace rotconv
