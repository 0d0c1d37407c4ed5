#pragma once

#include <string>

#include "mrroc/sensor.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// A tracker of six degrees of freedom, type `tracker`: the pose of a target in the frame of the tracker; in the
/// simulated world that of the MJCF sensors, mostly the world's. Task's thread.
class Tracker : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  Tracker(Task& task, const std::string& name);

  /// Of the target; not a number before the first reading.
  Pose pose() const noexcept;
};

}  // namespace mrroc
