#pragma once

#include "edp/force/force_sensor.hpp"
#include "edp/hardware.hpp"
#include "edp/servo/robot_ticker.hpp"
#include "edp/servo/servo.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::driver_faults {

inline constexpr double kPeriod = 0.002;  // s, of the servo

/// A robot with its driver, and the simulated device behind the driver, in this process.
class Device {
 public:
  virtual ~Device() = default;
  virtual const RobotModel& model() const = 0;
  /// Opened.
  virtual edp::Hardware& hardware() = 0;
  /// Null: the robot has no force sensor.
  virtual edp::ForceSensor* wrist() { return nullptr; }
  /// Waits for the servo's next tick.
  virtual edp::RobotTicker::Place wait_next() = 0;
  /// Speed of the fastest joint now, rad/s; `seen` is the servo's last tick.
  virtual double speed(const edp::Snapshot& seen) = 0;
};

}  // namespace mrroc::driver_faults
