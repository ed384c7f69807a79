#pragma once

#include <Eigen/Core>

#include <rotconv/frame.hpp>
#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// A representation's kinematic equation on plain numbers in the representation's own order. Of the Spec the sequence
/// and the unit count.
struct RateCodec {
    void (*rate)(const Spec& spec, const double* numbers, const Eigen::Vector3d& w, Frame frame,
                 double* rates) noexcept;
    Eigen::Vector3d (*angular_velocity)(const Spec& spec, const double* numbers, const double* rates,
                                        Frame frame) noexcept;
    /// Of the numbers, and of the rotation that they were read as; null where those of the rotation serve.
    Sensitivity (*sensitivity)(const Spec& spec, const double* numbers, const Rotation& rotation) noexcept;
};

/// @pre has_rates(name)
[[nodiscard]] const RateCodec& rate_codec_of(RepresentationId name) noexcept;

/// The axes of the inverse rotation's angular velocity where those of the rotation's are `frame`; its components are
/// the negative ones.
constexpr Frame inverse_of(Frame frame) noexcept { return frame == Frame::body ? Frame::reference : Frame::body; }

} // namespace rotconv
