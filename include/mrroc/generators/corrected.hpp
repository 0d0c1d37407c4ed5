#pragma once

#include <functional>
#include <memory>

#include "mrroc/coordinated.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Bounds of what `Corrected` adds to the MP's trajectory.
struct CorrectionLimits {
  double travel = 0.01;               ///< m, of the translation
  double turn = 0.05;                 ///< rad, of the rotation
  double speed = 0.02;                ///< m/s
  double angular_speed = 0.1;         ///< rad/s
  double acceleration = 0.04;         ///< m/s^2; the jerk is 10 / s times that
  double angular_acceleration = 0.2;  ///< rad/s^2
};

/// A correction by an ECP's own sensors of the trajectory of its MP, equation (11): the MP commands the pose P (or
/// joints), and this robot goes to P D, where D follows the correction C that a function of the program computes at
/// each step from readings of sensors in the Move's list. x = (translation, rotation vector) of D approaches that of C,
/// shortened to `travel` and `turn`, in a straight line: with the speed, acceleration and jerk of the limits, and
/// exponentially with 2 / s near it. The joints need room for that beside the MP's motion: a path at their limits
/// leaves none, and the EDP refuses the command.
///
/// D is without displacement again where the MP's generator plans from the robot's state, which is a corrected one: the
/// function is to give what is still to be corrected from there on.
class Corrected : public Coordinated {
 public:
  /// C, in the axes of P. Called once per step, must not allocate.
  using Correction = std::function<Pose()>;

  /// Throws NonFatalError(invalid_argument) without a function and for limits that are not above 0.
  Corrected(Superior& superior, Robot& robot, Correction correction, const CorrectionLimits& limits = {});
  ~Corrected() override;

  void start() override;
  void resume() override;
  /// Throws NonFatalError: not_finite for a correction that is not finite; invalid_argument for a command of the MP
  /// that is relative or neither of joints nor a pose.
  void next_state() override;

  /// D at the end of the step commanded last.
  Pose correction() const noexcept;
  /// The function asked for more than `travel` or `turn` at the last step.
  bool saturated() const noexcept;

 private:
  struct Law;
  std::unique_ptr<Law> law_;
};

}  // namespace mrroc
