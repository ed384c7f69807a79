// The attitude of a body whose gyroscope is read a hundred times a second: a tenth of a turn a second about z.

#include <iostream>
#include <numbers>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

int main() {
    Propagator propagator(PropagationSettings{});                 // the quaternion, with magnus4
    const Eigen::Vector3d rate(0, 0, 0.1 * 2 * std::numbers::pi); // radians a second, body axes
    Rotation attitude;
    for (int i = 0; i <= 100; ++i) {
        const PushResult pushed = propagator.push(i == 0 ? 0.0 : 0.01, rate); // seconds since the sample before
        if (pushed.refused != Error::none) {
            std::cerr << message(pushed.refused) << '\n';
            return 1;
        }
        if (pushed.answer && pushed.answer->attitude) {
            attitude = *pushed.answer->attitude;
        }
    }
    const auto rpy = euler::from_rotation(attitude, roll_pitch_yaw, AngleUnit::degrees);
    std::cout << "after a second: " << attitude << ", yaw " << rpy.angles.z() << " degrees\n";
}
