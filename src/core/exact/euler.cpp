#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::euler{};
constinit const ExactCodec codecs::rpy{};

} // namespace rotconv::ROTCONV_EXACT
