#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The IRb-6 with five axes, as a task program declares it: `Irb6FiveAxis arm{*this};`. Axes 0..4: column, lower arm,
/// upper arm, wrist pitch, roll about the tool's axis, in rad; poses are of the tool frame in the base frame at the
/// shoulder. The tool's axis lies in the vertical plane of the arm: other poses are out of the workspace.
class Irb6FiveAxis : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// irb6_five_axis, ConfigurationError when its parameter file is invalid.
  explicit Irb6FiveAxis(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the tool pointing straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);
};

}  // namespace mrroc
