#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The IRb-60, as a task program declares it: `Irb60 arm{*this};`. Built as the IRb-6 with six axes: column, lower arm,
/// upper arm, wrist pitch, wrist roll, tool roll, in rad; poses are of the tool frame in the base frame at the
/// shoulder.
class Irb60 : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// irb60, ConfigurationError when its parameter file is invalid.
  explicit Irb60(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the tool pointing straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);
};

}  // namespace mrroc
