#include "axis_half_angle.hpp"

#include "elementary.hpp"
#include "scaling.hpp"

namespace rotconv::ROTCONV_EXACT {

void AxisHalfAngles::take_apart(const Rotations& rotations, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        const double leader_of_two = rotations.y.hi[i] != 0.0 ? rotations.y.hi[i] : rotations.z.hi[i];
        const double leader_of_three = rotations.x.hi[i] != 0.0 ? rotations.x.hi[i] : leader_of_two;
        const double leader = rotations.w.hi[i] != 0.0 ? rotations.w.hi[i] : leader_of_three;
        const double sign = leader < 0.0 ? -1.0 : 1.0;
        const Scale scale = scale_to_unit(largest_magnitude(rotations.x.hi[i], rotations.y.hi[i], rotations.z.hi[i]));
        const Real own_x = scaled(rotations.x[i], sign * scale.there);
        const Real own_y = scaled(rotations.y[i], sign * scale.there);
        const Real own_z = scaled(rotations.z[i], sign * scale.there);
        x.set(i, own_x);
        y.set(i, own_y);
        z.set(i, own_z);
        w.set(i, scaled(rotations.w[i], sign));
        length.set(i, root(quick_sum(quick_sum(square(own_x), square(own_y)), square(own_z))));
        back[i] = scale.back;
    }
}

void AxisHalfAngles::find_angles(std::size_t rows, AngleUnit unit) noexcept {
    Column unscaled{};
    for (std::size_t i = 0; i < rows; ++i) {
        unscaled.set(i, scaled(length[i], back[i]));
    }
    angles_of(w, unscaled, rows, unit, angle);
    const Real unit_factor = scaled(unit == AngleUnit::degrees ? degrees_per_radian : Real(1.0), 2.0);
    for (std::size_t i = 0; i < rows; ++i) {
        // there tan(x) = x, and what the length lost below the smallest double is not needed
        const bool tiny = back[i] < 0x1p-200;
        const Real linear = length[i] / choose(tiny, w[i], 1.0) * unit_factor;
        angle.set(i, choose(tiny, linear, scaled(angle[i], 2.0)));
        angle_back[i] = tiny ? back[i] : 1.0;
    }
}

} // namespace rotconv::ROTCONV_EXACT
