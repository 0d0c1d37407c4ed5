#pragma once

#include <string>

#include "config/deployment.hpp"
#include "mrroc/types.hpp"
#include "sim/scene/model.hpp"

namespace mrroc::vsp {

/// A simulated camera: its pose in the world's model, and its mount. It is the first of these that exists:
///
///   1. the MJCF camera that the key `camera` names
///   2. the MJCF camera `<robot>/<sensor>`, then `<sensor>`
///   3. the keys `position` and `rotation`, in the flange frame of `robot` or in the world
///
/// The flange frame is the robot's body or site `flange`. A camera of a robot must be fixed to the flange, through any
/// bodies without joints between; a camera without a robot must be fixed in the world.
struct CameraMount {
  int body = 0;                     ///< that carries it
  Pose in_body = Pose::Identity();  ///< of the camera: z along the view, x right, y down
  Pose mount = Pose::Identity();    ///< in the flange frame, or in the world
  double field_of_view = 0;         ///< the MJCF camera's, rad; 0: not an MJCF camera
  std::string name = {};            ///< of the MJCF camera
};

/// Throws SystemError(configuration): none of the three (the message lists the MJCF's cameras), two of them, a camera
/// that tracks a body, or that is fixed to a wrong body.
CameraMount find_camera(const mjModel& model, const config::SensorEntry& entry);

}  // namespace mrroc::vsp
