#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The tripod with a wrist and a milling spindle, as a task program declares it: `SerialParallel machine{*this};`. Axes
/// 0..2: legs A, B, C in m; 3..5: turn, bend and roll of the wrist in rad. Poses are of the tool frame, its origin at
/// the cutter's tip, in the base frame: z up, on the common axis of legs A and C, above the board.
class SerialParallel : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// serial_parallel, ConfigurationError when its parameter file is invalid.
  explicit SerialParallel(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the spindle pointing straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);
};

}  // namespace mrroc
