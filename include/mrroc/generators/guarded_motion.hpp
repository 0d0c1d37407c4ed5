#pragma once

#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Guarded approach by force: the tool moves with a velocity until it meets an obstacle. The robot's EDP guards the
/// tool axes along the motion at every servo tick, with the admittance b = |v| / (2 contact force): the settled
/// force is at most twice the contact force, however late the task detects it. The other axes keep their position. The
/// tool reaches the velocity with `acceleration`.
///
/// Ends on its own when the tool presses with the contact force along its path; `touched()` returns the pose. A
/// condition ends a motion without contact: `.until(Travelled{arm, 0.1})`; then `touched()` is empty. The impact
/// depends on the tool's mass and the drives' lag: about v sqrt(m k) on a surface of stiffness k. The robot needs
/// `force_sensor` in the deployment. (The original's `tff_gripper_approach`; `GuardedApproach` uses a range sensor.)
class GuardedMotion : public Generator {
 public:
  /// `velocity` m/s in tool axes; `contact_force` N. Throws NonFatalError(invalid_argument) unless all values are
  /// finite and above 0.
  GuardedMotion(Robot& robot, const Eigen::Vector3d& velocity, double contact_force, double acceleration = 0.2);

  void start() override;
  void resume() override;
  bool terminal_condition() override;
  void next_state() override;

  /// The measured tool pose in the base frame at contact; empty without contact.
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
