#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The IRb-6 on its post, as a task program declares it: `Irb6 arm{*this};`. Axes 0..5: column, lower arm, upper arm,
/// wrist pitch, wrist roll, tool roll, in rad; poses are of the tool frame in the base frame at the shoulder.
class Irb6 : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// irb6, ConfigurationError when its parameter file is invalid.
  explicit Irb6(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the tool pointing straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);
};

}  // namespace mrroc
