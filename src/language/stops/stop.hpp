#pragma once

#include <array>

#include "geometry/desired_state.hpp"
#include "language/joints/axis_stop.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc {

/// The robot's stop: every axis comes to rest as fast as its own acceleration and jerk limits allow (AxisStop), from
/// any desired state, independent of other processes. The planner accepts a macrostep only if the stop from each of its
/// ticks stays inside the limits, so a stop needs no permission. Allocates nothing but in its constructor; the planner
/// and the servo have one each.
class Stop {
 public:
  /// Throws SystemError when an axis has no acceleration or jerk limit.
  Stop(const RobotParameters& parameters, double period);
  /// Uses from now on the limits of `parameters`, from which a Stop has been made before.
  void use(const RobotParameters& parameters) noexcept;

  void plan(const DesiredState& from) noexcept;
  /// State t seconds after the start; from the end on exactly at rest.
  DesiredState at(double t) const noexcept;
  /// Servo ticks until rest, rounded up; 0 when `from` was at rest.
  std::uint32_t ticks() const noexcept { return ticks_; }
  /// Its end, at rest.
  DesiredState end() const noexcept;
  const AxisStop& axis(int i) const noexcept { return axes_[static_cast<std::size_t>(i)]; }

 private:
  struct Limits {
    double acceleration, jerk;
  };
  int count_;
  double period_;
  std::array<Limits, kMaxJoints> limits_{};
  std::array<AxisStop, kMaxJoints> axes_{};
  std::uint32_t ticks_ = 0;
};

}  // namespace mrroc
