#pragma once

#include <array>
#include <cstdint>

#include "edp/hardware.hpp"
#include "language/limit_switches.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

using mrroc::LimitSwitches;

/// Watches the limit switches. An axis that comes onto a switch, or is to move farther onto the one on which it is,
/// stops the robot. It may stay on a switch and it may move away. A switch on which an axis has stopped is remembered
/// until the axis has left it by following_error_max: regulation back and forth at the same position does not count as
/// coming onto it.
///
/// The servo's thread; allocates nothing, never throws.
class LimitSwitchWatch {
 public:
  static_assert(kMaxJoints <= 16, "a bit for each axis");

  /// `parameters` must outlive this object.
  explicit LimitSwitchWatch(const RobotParameters& parameters) noexcept : parameters_(&parameters) {}

  /// Takes the switches and shaft positions (rad) of a tick. `increment`: of the shafts' set-points in the last tick.
  /// `finding` is the axis that finds its own switches (the synchronisation), `kEvery`: no axis is watched, -1:
  /// all are watched. Returns the first axis to stop for, or -1.
  int check(const HardwareInput& input, const JointVector& increment, int finding) noexcept;
  static constexpr int kEvery = -2;

  /// Of the last check.
  const LimitSwitches& on() const noexcept { return on_; }

 private:
  struct Known {
    bool is = false;
    double at = 0;  ///< where it closed or opened, rad
  };
  bool check(Known& known, bool on, double motor, double towards, double leave) const noexcept;

  const RobotParameters* parameters_;
  LimitSwitches on_;
  std::array<Known, kMaxJoints> lower_{}, upper_{};
};

}  // namespace mrroc::edp
