#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

constinit const ExactCodec codecs::axis_angle{};

} // namespace rotconv::ROTCONV_EXACT
