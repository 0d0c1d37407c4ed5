#pragma once

#include <memory>

#include "sensors/camera/pictures/picture_source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// The properties of a hardware camera from the keys, which the camera itself does not report.
struct HardwareCamera {
  Intrinsics intrinsics;
  Pose mount = Pose::Identity();
};

/// From `intrinsics`, `distortion`, `width`, `height`, `position`, `rotation`. Throws SystemError(configuration).
HardwareCamera hardware_camera(const config::SensorEntry& entry);

/// The source of the key `device`: a file is played (`PlayedVideo`), anything else is a camera (`LiveCamera`). Throws
/// SystemError(configuration) when it cannot be opened or its pictures have another size.
std::unique_ptr<PictureSource> open_device(const SourceContext& context, cv::Mat& picture);

}  // namespace mrroc::vsp
