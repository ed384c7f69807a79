#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::quat{};

} // namespace rotconv::ROTCONV_EXACT
