#pragma once

#include <optional>

#include "sensors/force_torque/low_pass.hpp"
#include "vsp/noise.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Six-axis force/torque sensor between a wrist and its tool. v is the wrench w that the environment exerts on the
/// tool, in the axes of the sensor frame and about its origin (N, N m), after bias: a tool that points down, its z axis
/// downward, and presses on a table reads a *negative* force_z.
///
/// r is what the hardware measures (and MuJoCo's `force` and `torque` sensors give): the wrench s that the wrist exerts
/// on the tool to support it. At rest the wrenches on the tool add up to zero, w + g + s = 0, g being its weight, so
///
///     u = -s - g + noise        v = low_pass(u) - bias
///     g = (f, c x f),  f = R^T (m a)
///
/// with m `tool_mass`, c `tool_centre`, a `gravity`, R the tool's orientation in the robot's base frame, from e_l: the
/// sensor's axes are taken as parallel to the tool frame's. With tool_mass 0, g is left in the reading and `bias` takes
/// it out for the present orientation. Inertial forces of the tool are part of w.
///
/// A component of s beyond its range is NonFatalError(sensor_out_of_range) at that reading, and the filter does not see
/// it. With a mass, before the pose of a synchronised robot is known: NonFatalError(sensor_not_ready).
class ForceTorqueSensor final : public VirtualSensor {
 public:
  std::vector<Channel> channels() const override;
  std::vector<Channel> raw_channels() const override;
  void configure(const config::SensorEntry& entry, double servo_period) override;
  bool continuous() const noexcept override { return filter_.enabled(); }
  void track(const RawReading& r) noexcept override;
  void effector_state(const RobotState& e) noexcept override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  bool bias(const RawReading& r) noexcept override;

 private:
  /// Index of the first value beyond its range.
  std::optional<int> beyond_range(const RawReading& r) const noexcept;
  bool weight_unknown() const noexcept { return tool_mass_ > 0 && !tool_orientation_; }
  bool usable(const RawReading& r) const noexcept { return !beyond_range(r) && !weight_unknown(); }
  Wrench tool_weight() const noexcept;
  Wrench noise(Tick tick) const noexcept;

  Wrench range_ = Wrench::Zero();
  double force_noise_ = 0;
  double torque_noise_ = 0;
  double tool_mass_ = 0;
  Eigen::Vector3d tool_centre_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();
  Noise noise_{""};
  LowPass filter_;
  std::optional<Eigen::Matrix3d> tool_orientation_;
  Wrench bias_ = Wrench::Zero();
};

}  // namespace mrroc::vsp
