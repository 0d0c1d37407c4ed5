#pragma once

#include <opencv2/core/types.hpp>

#include "config/deployment.hpp"
#include "mrroc/sensors/camera_configuration.hpp"
#include "sensors/camera/intrinsics.hpp"

/// A task's configurations of a camera as the deployment's keys, so that one check serves both. All functions throw
/// NonFatalError(invalid_argument) or SystemError(configuration) naming the field or the key, the value and the
/// expected value. The VSP's thread; they allocate.
namespace mrroc::vsp {

/// `entry` with `detect = "marker"` and the marker's keys.
config::SensorEntry with(config::SensorEntry entry, const LookFor& marker);
/// `entry` with `detect = "blob"` and the keys of colour and plane.
config::SensorEntry with(config::SensorEntry entry, const LookForColour& blob);
/// The part of the picture; the whole of it for a region without a size.
cv::Rect part_of(const Intrinsics& picture, const Region& region);
/// The camera that sees only this part.
Intrinsics cropped(Intrinsics picture, const cv::Rect& part) noexcept;

}  // namespace mrroc::vsp
