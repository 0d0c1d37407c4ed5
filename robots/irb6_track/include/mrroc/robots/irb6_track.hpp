#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The IRb-6 on its track, as a task program declares it: `Irb6Track arm{*this};`. Axes: track (m, along y), then those
/// of the IRb-6: column, lower arm, upper arm, wrist pitch, wrist roll, tool roll (rad). Poses are of the tool frame in
/// the base frame, which is at the shoulder when the track is at 0.
class Irb6Track : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// irb6_track, ConfigurationError when its parameter file is invalid.
  explicit Irb6Track(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the tool pointing straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);
};

}  // namespace mrroc
