#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::rotvec{};

} // namespace rotconv::ROTCONV_EXACT
