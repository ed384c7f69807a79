#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::five_d{};

} // namespace rotconv::ROTCONV_EXACT
