#include "codec.hpp"

#include <array>

namespace rotconv {

const Codec& codec_of(RepresentationId name) noexcept {
#define ROTCONV_LINE(id) &codecs::id,
    static constexpr std::array table{ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE
    return *table[static_cast<std::size_t>(name)];
}

} // namespace rotconv
