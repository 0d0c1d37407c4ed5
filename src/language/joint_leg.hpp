#pragma once

#include <memory>

#include "mrroc/robot_command.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// One way in joint space for a generator that goes along several: as `JointLine` plans it, time-optimal under the
/// limits scaled by speed, speed^2, speed^3, but without allocating, so that a step may plan the next one. Task's
/// thread.
class JointLeg {
 public:
  /// Allocates. `parameters` must outlive it.
  explicit JointLeg(const RobotParameters& parameters);
  ~JointLeg();
  JointLeg(JointLeg&&) noexcept;
  JointLeg& operator=(JointLeg&&) noexcept;

  /// From the desired state, in motion or not, to rest at `target`. Throws NonFatalError(invalid_argument).
  void plan(const RobotState& state, const JointVector& target, double speed);
  double duration() const noexcept;
  /// Whether the end lies at or before `time` (s since the start); sums of step durations are not exact.
  bool over(double time) const noexcept { return time >= duration() - 1e-9; }
  /// The command of a macrostep that ends `time` s after the start.
  void write(double time, RobotCommand& command) const;

 private:
  struct Plan;
  const RobotParameters* parameters_;
  JointVector target_;
  std::unique_ptr<Plan> plan_;
};

/// Throws NonFatalError unless `target` has a finite value within the limits for each axis: invalid_argument,
/// not_finite, joint_limit. `what` says whose target it is.
void check_joints(const RobotParameters& parameters, const JointVector& target, const char* what);

}  // namespace mrroc
