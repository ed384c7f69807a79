#include "codec.hpp"

#include <array>

namespace rotconv {

const Codec& codec_of(RepresentationId name) noexcept {
#define ROTCONV_LINE(id) &codecs::id,
    static constexpr std::array table{ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE
    return *table[static_cast<std::size_t>(name)];
}

Reading read_within(const Spec& spec, const double* numbers, double tolerance) noexcept {
    const Reading reading = read_row(spec, numbers);
    if (!reading || reading.defect() <= tolerance) {
        return reading;
    }
    const double defect = codec_of(spec.name).exact_defect(numbers);
    return defect <= tolerance ? Reading(*reading, defect) : Reading(Error::defect, defect);
}

void to_own_order(const Spec& spec, const double* written, std::size_t rows, double* own, std::size_t width) noexcept {
    const auto order = spec.order();
    const std::size_t size = spec.size();
    for (std::size_t row = 0; row < rows; ++row, written += width, own += size) {
        for (std::size_t i = 0; i < size; ++i) {
            own[order[i]] = written[i];
        }
    }
}

void to_written_order(const Spec& spec, const double* own, std::size_t rows, double* written) noexcept {
    const auto order = spec.order();
    const std::size_t size = spec.size();
    for (std::size_t row = 0; row < rows; ++row, written += size, own += size) {
        for (std::size_t i = 0; i < size; ++i) {
            written[i] = own[order[i]] + 0.0;
        }
    }
}

} // namespace rotconv
