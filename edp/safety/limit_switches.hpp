#pragma once

#include <array>
#include <cstdint>

#include "edp/hardware.hpp"
#include "language/limit_switches.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

using mrroc::LimitSwitches;

/// Watches the limit switches: an axis that comes onto one stops the robot, and so does one that is to move farther
/// onto the one on which it stands. It may stand there and it may move away. A switch on which an axis has stopped is
/// known until the axis has left it by following_error_max: what regulates it back and forth on the spot comes onto
/// nothing.
///
/// The servo's thread; allocates nothing, never throws.
class LimitSwitchWatch {
 public:
  static_assert(kMaxJoints <= 16, "a bit for each axis");

  /// `parameters` must outlive this object.
  explicit LimitSwitchWatch(const RobotParameters& parameters) noexcept : parameters_(&parameters) {}

  /// Takes the switches and shaft positions (rad) of a tick. `increment`: of the shafts' set-points in the last tick.
  /// `finding` is the axis that finds its own switches (the synchronisation), `kEvery`: no one is to be stopped, -1:
  /// all are watched. The first axis to stop for; -1: none.
  int look(const HardwareInput& input, const JointVector& increment, int finding) noexcept;
  static constexpr int kEvery = -2;

  /// Of the last look.
  const LimitSwitches& on() const noexcept { return on_; }

 private:
  struct Known {
    bool is = false;
    double at = 0;  ///< where it closed or opened, rad
  };
  bool look(Known& known, bool on, double motor, double towards, double leave) const noexcept;

  const RobotParameters* parameters_;
  LimitSwitches on_;
  std::array<Known, kMaxJoints> lower_{}, upper_{};
};

}  // namespace mrroc::edp
