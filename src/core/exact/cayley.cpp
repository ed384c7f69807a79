#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::cayley{};

} // namespace rotconv::ROTCONV_EXACT
