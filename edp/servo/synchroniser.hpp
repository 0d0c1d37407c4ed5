#pragma once

#include <array>

#include "edp/hardware.hpp"
#include "geometry/desired_state.hpp"
#include "language/joints/axis_stop.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// Finds the absolute position of every shaft, one axis after the other in the robot's `synchro_order`, as the original
/// does (`mrrocpp` 1.3): at coarse speed onto the synchronisation switch, stop, at fine speed back off it, on to the
/// next zero pulse of the encoder, stop. There the shaft is at motor_synchro.
///
/// An axis that starts on its switch leaves it at coarse speed, then begins: the original leaves it at fine speed,
/// which takes minutes where the switch covers half of the axis's range. One that starts beyond a short switch runs to
/// its limit switch and comes back across. Every change of speed keeps the acceleration and jerk limits of `shafts`.
///
/// The servo's thread; allocates nothing, never throws.
class Synchroniser {
 public:
  enum class Status : std::uint8_t { running, done, failed };

  /// `robot`: the robot's parameters; `shafts`: those of its ShaftModel.
  Synchroniser(const RobotParameters& robot, const RobotParameters& shafts, double period) noexcept;

  /// From rest at `shafts`.
  void start(const JointVector& shafts) noexcept;
  /// One tick: takes the drives' feedback, gives the next set-point of the shafts. `failed`: an axis has met a limit
  /// switch where the synchronisation switch should have closed or opened before, or found no zero pulse within
  /// kTurnsWithoutPulse revolutions.
  Status step(const HardwareInput& input, DesiredState& desired) noexcept;

  /// The offset to add to every shaft position; after `done`.
  const JointVector& shift() const noexcept { return shift_; }
  /// The axis being synchronised, or the one that failed.
  int axis() const noexcept;

  static constexpr double kTurnsWithoutPulse = 3;

 private:
  enum class Phase : std::uint8_t {
    begin,
    leave,   ///< off the switch at coarse speed
    coarse,  ///< onto the switch
    back,    ///< from the limit switch to the far side of a short switch
    stop,
    slid,  ///< back to a switch that the stop has slid across
    fine,  ///< off the switch
    pulse,
    rest
  };

  void change_speed(double velocity) noexcept;
  void enter(Phase phase, double velocity) noexcept;
  Status next_axis() noexcept;

  struct Axis {
    double coarse, fine, synchro, acceleration, jerk;
  };
  std::array<Axis, kMaxJoints> axes_{};
  std::array<std::size_t, kMaxJoints> order_{};
  std::size_t count_;
  double period_;

  std::size_t place_ = 0;  ///< in `order_`
  Phase phase_ = Phase::begin;
  bool turned_back_ = false;
  AxisStop ramp_;          ///< of the present axis, in a frame that moves with `speed_`
  double speed_ = 0;       ///< rad/s
  double time_ = 0;        ///< since `ramp_` began, s
  double fine_start_ = 0;  ///< where the switch opened
  double found_ = 0;       ///< the zero pulse
  DesiredState desired_;
  JointVector shift_;
};

}  // namespace mrroc::edp
