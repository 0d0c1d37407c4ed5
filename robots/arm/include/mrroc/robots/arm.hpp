#pragma once

#include <string>

#include "mrroc/robot.hpp"
#include "mrroc/robots/posture_motion.hpp"

namespace mrroc {

/// Any arm whose parameter file describes it as a chain of joints (table `[chain]`), as `mrroc robot add` writes it
/// from a URDF: `Arm arm{*this, "arm"};`. Its type is the deployment's. Axes in the order of the file, rad or m; poses
/// are of the tool frame in the base frame of the chain, m.
class Arm : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// robot, ConfigurationError when its parameter file is invalid or has no chain.
  explicit Arm(Task& task, const std::string& name = "");

  /// The tool pose at (x, y, z) m in the base frame with the tool's z axis straight down and its x axis along the
  /// base's.
  static Pose tool_down(double x, double y, double z);

  /// Toward the joints `wished`, while the flange stays: `Move({arm}, {}, arm.posture(wished));`.
  PostureMotion posture(const JointVector& wished, double speed = 0.5) { return {*this, wished, speed}; }
};

}  // namespace mrroc
