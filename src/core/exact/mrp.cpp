#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::mrp{};

} // namespace rotconv::ROTCONV_EXACT
