#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::two_column{};

} // namespace rotconv::ROTCONV_EXACT
