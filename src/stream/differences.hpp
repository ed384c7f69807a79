#pragma once

#include <rotconv/frame.hpp>
#include <rotconv/spec.hpp>

#include "row_operation.hpp"

namespace rotconv::stream {

/// What differences are made of rows of a time and an attitude.
struct DifferenceRows {
    Spec spec;            ///< of the attitude
    int time_power = 0;   ///< times are in units of 10^time_power seconds, 0 or less
    bool degrees = false; ///< the angular velocity in degrees a second
    Frame frame = Frame::body;
    double tolerance = 0.0;   ///< see ConversionSettings
    bool sensitivity = false; ///< a report of every row
};

/// The angular velocity since the row before: the rotation vector from that attitude to this over the time between. The
/// first row has that of the step after it, nan where there is none.
[[nodiscard]] RowOperation differences_operation(const DifferenceRows& rows);

} // namespace rotconv::stream
