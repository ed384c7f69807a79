#include "vector_parts.hpp"

namespace rotconv {

void take_apart(const Rotation* rotations, std::size_t rows, VectorParts& parts) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double sign = rotations[i].sign();
        const Split x = split(rotations[i].x() * sign);
        const Split y = split(rotations[i].y() * sign);
        const Split z = split(rotations[i].z() * sign);
        const Root length = length_of(x, y, z);
        parts.x[i] = x.value;
        parts.y[i] = y.value;
        parts.z[i] = z.value;
        parts.half.x[i] = rotations[i].w() * sign;
        parts.half.x_low[i] = 0.0;
        parts.half.y[i] = length.hi;
        parts.half.y_low[i] = length.lo;
        parts.inverse[i] = length.inverse;
    }
}

} // namespace rotconv
