#pragma once

#include <memory>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Straight line in joint space, time-optimal under the robot's velocity, acceleration and jerk limits scaled by
/// `speed` (Ruckig, phase-synchronised: all joints start and end together). It starts from the desired state, in motion
/// or at rest, and ends at rest. The motion ends on its own when the last macrostep has been commanded.
///
/// When the robot already moves, a joint that is too fast for the scaled limits, or could not stop before its target
/// with them, brakes with the unscaled limits; the speed factor applies after that. So no joint overshoots its target
/// by more than it needs to brake, at any speed (src/language/joints/joint_leg.hpp).
///
/// The EDP joins the points of a macrostep's ends by polynomials of degree five. Their jerk is the least-squares fit of
/// the trajectory's by a parabola, at most 2.18 times the trajectory's (the fit's Lebesgue constant), and their
/// velocity and acceleration overshoot a little. So the line is planned with 0.99 of the velocity limits, 0.9 of the
/// acceleration limits and 0.45 of the jerk limits. With macrosteps longer than a ramp of the acceleration the EDP may
/// still refuse a point.
class JointLine : public Generator {
 public:
  /// To joint positions (rad or m). `speed` in [1e-6, 1] scales velocity by `speed`, acceleration by speed^2, jerk by
  /// speed^3, so that the trajectory is only stretched in time. Throws NonFatalError: invalid_argument (size, speed),
  /// not_finite, joint_limit.
  JointLine(Robot& robot, const JointVector& target, double speed = 0.5);
  /// To a tool pose in the robot's base frame. Among all branches and turns within joint and motor limits it chooses
  /// the posture nearest to the desired joints at the start, by sum ((q_i - desired_i) / velocity_max_i)^2; a free
  /// joint of a singular pose keeps its value if possible. A pose that the robot cannot reach exactly is replaced by
  /// the nearest one within 1 mm and 5 mrad. Throws NonFatalError: not_finite, invalid_argument when the pose is not a
  /// rigid transform (R^T R = I within 5e-3); `start()`: out_of_workspace, joint_limit, motor_limit when no posture
  /// exists.
  JointLine(Robot& robot, const Pose& target, double speed = 0.5);
  ~JointLine() override;
  JointLine(JointLine&&) noexcept;
  JointLine& operator=(JointLine&&) noexcept;

  void start() override;
  bool terminal_condition() override;
  void next_state() override;

  /// Duration of the whole motion, s; after `start()`.
  double duration() const noexcept;
  /// Distance of the posture's tool pose from the target pose; after `start()`.
  PoseDeviation deviation() const noexcept { return deviation_; }

 private:
  struct Plan;
  void check_target(const JointVector& target) const;

  Robot* robot_;
  bool to_pose_;
  JointVector target_;
  Pose target_pose_ = Pose::Identity();
  double speed_;
  PoseDeviation deviation_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mrroc
