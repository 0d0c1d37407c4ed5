#pragma once

#include "mrroc/robot.hpp"
#include "mrroc/superior.hpp"

namespace mrroc {

/// The displacement D of a robot's tool from the pose P that the MP commands: the robot is commanded to P D. D is a
/// translation d and a rotation vector phi, stacked to x = (d, phi), both in the axes of P; x is continuous with its
/// first two derivatives, with a constant jerk in each macrostep. Task's thread; allocates nothing.
class Displacement {
 public:
  using Axes = Eigen::Matrix<double, 6, 1>;

  /// x at the end of the macrostep commanded last, m and rad, and its derivatives.
  const Axes& value() const noexcept { return value_; }
  const Axes& speed() const noexcept { return speed_; }
  /// No displacement and at rest.
  void reset() noexcept;
  /// Keeps x at its value from now on.
  void halt() noexcept;
  /// Goes to the end of the coming macrostep of `step` s, with the jerk that makes dx/dt approach `wanted` as through a
  /// low-pass of time constant `lag` (at least `step`). `most`: of the acceleration, m/s^2 and rad/s^2; it changes by
  /// at most that within 0.1 s.
  void advance(const Axes& wanted, double lag, double step, const Eigen::Vector2d& most) noexcept;
  /// Commands `robot` P D at the macrostep's end, with P by the MP's command, of kind joint or pose. Without a
  /// displacement the command is the MP's own, bit for bit. Throws NonFatalError(invalid_argument) for relative
  /// commands and other kinds, with `caller`.
  void command(Robot& robot, const RobotCommand& wished, const char* caller) const;

 private:
  Axes value_ = Axes::Zero(), speed_ = Axes::Zero(), rate_ = Axes::Zero();
};

}  // namespace mrroc
