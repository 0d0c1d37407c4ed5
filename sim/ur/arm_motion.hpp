#pragma once

#include "sim/ur/joint_plant.hpp"

namespace mrroc::sim::ur {

/// The motion commands of URScript that the simulated controller has: servoj, speedj, stopj and movej, one at a time.
/// `targets` of each period go to the plant.
class ArmMotion {
 public:
  explicit ArmMotion(double period) : period_(period) {}

  /// Of this period.
  void servoj(const Six& position);
  void speedj(const Six& velocity, double acceleration);
  /// These last until `is_moving` is false.
  void stopj(double deceleration, const JointPlant& plant);
  void movej(const Six& to, double speed, double acceleration, const JointPlant& plant);

  bool is_moving() const noexcept { return stopping_ || moving_; }
  /// Ends every motion at once, as brakes do.
  void cancel() noexcept;
  /// The targets of the coming period; without a command the arm is held.
  JointTargets targets(const JointPlant& plant);

 private:
  JointTargets continue_move(const JointPlant& plant);
  JointTargets continue_stop(const JointPlant& plant);

  double period_;
  bool stopping_ = false, moving_ = false, commanded_ = false;
  JointTargets now_;
  double deceleration_ = 0;
  Six from_{}, to_{};
  double distance_ = 0, path_ = 0, path_speed_ = 0, speed_ = 0, acceleration_ = 0;
};

}  // namespace mrroc::sim::ur
