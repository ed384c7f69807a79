#include "axis_half_angle.hpp"

#include <cmath>

namespace rotconv {

ROTCONV_TARGET_CLONES void take_apart(const Rotations& rotations, std::size_t rows, AxisHalfAngles& parts) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double sign = std::copysign(1.0, rotations.w[i]);
        const Split x = split(rotations.x[i] * sign);
        const Split y = split(rotations.y[i] * sign);
        const Split z = split(rotations.z[i] * sign);
        const Root length = length_of(x, y, z);
        parts.x[i] = x.value;
        parts.y[i] = y.value;
        parts.z[i] = z.value;
        parts.half.x[i] = rotations.w[i] * sign;
        parts.half.y[i] = length.hi;
        parts.length_low[i] = length.lo;
        parts.inverse[i] = length.inverse;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (rotations.w[i] == 0.0) { // the vector part decides
            const Rotation q = rotations.at(i).canonical();
            parts.x[i] = q.x();
            parts.y[i] = q.y();
            parts.z[i] = q.z();
            parts.half.x[i] = 0.0;
        }
    }
    parts.half.set_sines(rows);
}

} // namespace rotconv
