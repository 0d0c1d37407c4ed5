#pragma once

#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Guarded approach by force: the tool moves with a velocity until it meets something. The axes of the tool that it
/// moves along are guarded by the robot's EDP at every servo tick, with the reciprocal damping b = |v| / (2 contact
/// force): what is met is pressed with twice the contact force at most, once it has settled, however late the task
/// notices. The other axes keep their place. The velocity is come up to with `acceleration`.
///
/// Ends on its own when the tool presses with the contact force along its way; `touched()` tells where. Meeting nothing
/// is for a condition to end: `.until(Travelled{arm, 0.1})`; then `touched()` is empty. The first contact costs what
/// the tool's mass and the drives' lag make of it: some v sqrt(m k) on a surface of stiffness k. The robot needs
/// `force_sensor` in the deployment. (The original's `tff_gripper_approach`; `GuardedApproach` is led by a range
/// sensor.)
class GuardedMotion : public Generator {
 public:
  /// `velocity` m/s in tool axes; `contact_force` N. Throws NonFatalError(invalid_argument) unless all is finite and
  /// above 0.
  GuardedMotion(Robot& robot, const Eigen::Vector3d& velocity, double contact_force, double acceleration = 0.2);

  void start() override;
  void resume() override;
  bool terminal_condition() override;
  void next_state() override;

  /// The measured tool in the base frame when it touched; nothing: it has not.
  const std::optional<Pose>& touched() const noexcept { return touched_; }

 private:
  Robot* robot_;
  Eigen::Vector3d velocity_;
  double contact_force_;
  double acceleration_;
  Eigen::Vector3d commanded_ = Eigen::Vector3d::Zero();
  std::optional<Pose> touched_;
};

}  // namespace mrroc
