#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::dcm{};

} // namespace rotconv::ROTCONV_EXACT
