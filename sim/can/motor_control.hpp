#pragma once

#include <cstdint>
#include <optional>

#include "canopen/drive_state.hpp"
#include "edp/hardware.hpp"
#include "edp/servo/regulator.hpp"
#include "edp/servo/synchroniser.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::sim {

/// Computes a simulated drive's motor current of one shaft from its set-points, once per cycle, by the axis's own
/// regulator (edp::Regulator). All angles are those of the plant's encoder, rad. Allocates in the constructor only.
class MotorControl {
 public:
  /// `period` in s: between two cycles.
  MotorControl(const AxisParameters& axis, double period);

  /// The shaft's state in this cycle; call it first.
  void measure(double position, const edp::AxisSwitches& switches) noexcept;
  double velocity() const noexcept { return (position_ - before_) / period_; }

  // one of these in each cycle; the current, A
  double off() noexcept;
  double follow_position(double position) noexcept;
  double follow_velocity(double velocity) noexcept;
  double follow_current(double current) noexcept;
  /// Slows down at `deceleration` (rad/s^2), then holds.
  double slow_down(double deceleration) noexcept;
  bool stands() const noexcept { return commanded_velocity_ == 0; }

  /// Searches for the zero pulse off the switch closed towards the positive (`direction` 1) or negative (-1) end.
  void start_homing(double direction, double speed_switch, double speed_zero) noexcept;
  /// One cycle of it.
  double follow_homing(edp::Synchroniser::Status& status) noexcept;
  /// Position of the zero pulse; after `done`.
  double found() const noexcept { return -homing_->shift()[0]; }

 private:
  double regulate(double position) noexcept;

  AxisParameters axis_;
  double period_;
  edp::Regulator regulator_;
  std::optional<edp::Synchroniser> homing_;
  edp::HardwareInput input_;
  double position_ = 0, before_ = 0;
  double commanded_ = 0, commanded_velocity_ = 0;
  bool measured_ = false;
};

}  // namespace mrroc::sim
