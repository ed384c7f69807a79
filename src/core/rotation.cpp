#include <rotconv/rotation.hpp>

#include "scaling.hpp"

namespace rotconv {

Rotation Rotation::from_components(double w, double x, double y, double z) noexcept {
    const auto scale = PowerOfTwo::to_unit(largest_magnitude(w, x, y, z));
    Rotation rotation;
    rotation.q_ = {scale(w), scale(x), scale(y), scale(z)};
    rotation.make_sign_canonical();
    return rotation;
}

Rotation Rotation::inverse() const noexcept {
    Rotation rotation;
    rotation.q_ = {q_[0], -q_[1], -q_[2], -q_[3]};
    rotation.make_sign_canonical();
    return rotation;
}

void Rotation::make_sign_canonical() noexcept {
    double leader = q_[0];
    for (std::size_t i = 1; leader == 0.0 && i < 4; ++i) {
        leader = q_[i];
    }
    const double sign = leader < 0.0 ? -1.0 : 1.0;
    for (double& component : q_) {
        component = component * sign + 0.0; // + 0.0 turns -0 into 0
    }
}

double Rotation::tiny_vector_length() const noexcept {
    const double largest = largest_magnitude(q_[1], q_[2], q_[3]);
    if (largest == 0.0) {
        return 0.0;
    }
    const auto scale = PowerOfTwo::to_unit(largest);
    const double x = scale(q_[1]);
    const double y = scale(q_[2]);
    const double z = scale(q_[3]);
    return scale.undone(std::sqrt((x * x + y * y) + z * z));
}

} // namespace rotconv
