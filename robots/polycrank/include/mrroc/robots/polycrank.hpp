#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The Polycrank, as a task program declares it: `Polycrank arm{*this};`. Axes 0..6: crank_1 to crank_6, tool_roll, in
/// rad, none of them limited: a joint may be any number of turns away from home. Poses are of the tool frame in the
/// base frame on the horizontal first axis.
class Polycrank : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// polycrank, ConfigurationError when its parameter file is invalid.
  explicit Polycrank(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the tool pointing straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);
};

}  // namespace mrroc
