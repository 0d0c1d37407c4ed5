#pragma once

#include <optional>

#include "mrroc/load.hpp"
#include "mrroc/sensors/force_torque.hpp"
#include "sensors/force_torque/gauges.hpp"
#include "sensors/force_torque/low_pass.hpp"
#include "vsp/noise.hpp"
#include "vsp/wrench_source.hpp"

namespace mrroc::vsp {

/// Six-axis force/torque sensor between a wrist and its tool. v is the wrench w that the environment exerts on the
/// tool, in the axes of the sensor frame and about its origin (N, N m), after bias: a tool that points down, its z axis
/// downward, and presses on a table reads a *negative* force_z.
///
/// r is the measurement of the hardware. Without a `calibration` (and from MuJoCo's `force` and `torque` sensors) the
/// wrench s that the wrist exerts on the tool to support it; with one, the voltages of six strain gauges (gauges.hpp).
/// The load on the sensor is l = -s - z, or M (gauges - gauge zero) - z, with z the key `zero`. At rest the wrenches on
/// the tool add up to zero, w + g + s = 0, g being its weight, so
///
///     u = l - g + noise         v = low_pass(u) - bias
///     g = (f, c x f) + (f_c, c_c x f_c),  f = R^T (m a),  f_c = R^T (m_c a)
///
/// with m `tool_mass`, c `tool_centre`, m_c and c_c those of what the tool carries (configuration `Carrying`, 0 at the
/// start), a `gravity`, R the orientation of the sensor frame in the robot's base frame:
/// the flange's, from e_l (pose and tool frame in use), times that of the key `rotation`. With tool_mass 0, g remains
/// in the reading and `bias` removes it for the present orientation. Inertial forces of the tool are part of w.
///
/// A saturated gauge, or a component of l beyond its range, is NonFatalError(sensor_out_of_range) at that reading: no
/// value of it or of another reading is given, and the filter ignores it. With a mass, before the pose of a
/// synchronised robot is known: NonFatalError(sensor_not_ready).
class ForceTorqueSensor final : public WrenchSource {
 public:
  /// `support_force_x` ... `support_torque_z`, or `gauge_0` ... `gauge_5` when the deployment gives a calibration:
  /// after `configure()`.
  std::vector<Channel> raw_channels() const override;
  void configure(const config::SensorEntry& entry, double servo_period) override;
  /// With a calibration, gauges for the simulated world's wrist.
  std::unique_ptr<Source> open_source(const SourceContext& context) override;
  bool continuous() const noexcept override { return filter_.enabled(); }
  void track(const RawReading& r) noexcept override;
  void effector_state(const RobotState& e) noexcept override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  bool bias(const RawReading& r) noexcept override;
  /// `Carrying`, `LowPassAt` (mrroc/sensors/force_torque.hpp).
  void reconfigure(const Message& configuration) override;

  Pose mount() const override { return mount_; }
  Wrench load(const RawReading& r) const noexcept override;
  void carry(const Load& carried) noexcept override;
  /// Group delay of the low-pass for slow changes, s (`LowPass::delay`); 0 without.
  double delay() const noexcept { return filter_.delay(); }

 private:
  std::optional<int> saturated_gauge(const RawReading& r) const noexcept;
  /// Index of the first component beyond its range.
  std::optional<int> beyond_range(const Wrench& load) const noexcept;
  void report_out_of_range(const RawReading& r, SensorReading& v) const noexcept;
  bool weight_unknown() const noexcept { return tool_mass_ + carried_.mass > 0 && !orientation_; }
  bool measurable(const RawReading& r) const noexcept { return !saturated_gauge(r) && !beyond_range(load(r)); }
  Wrench weight() const noexcept;
  void apply(const Carrying& carrying);
  void apply(const LowPassAt& low_pass);
  Wrench noise(Tick tick) const noexcept;

  Wrench range_ = Wrench::Zero();
  double force_noise_ = 0;
  double torque_noise_ = 0;
  Wrench zero_ = Wrench::Zero();  ///< the reading without load
  double tool_mass_ = 0;
  Eigen::Vector3d tool_centre_ = Eigen::Vector3d::Zero();
  Load carried_;
  double servo_period_ = 0;
  bool follows_ = false;  ///< e_l comes
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();
  Noise noise_{""};
  LowPass filter_;
  std::optional<Gauges> gauges_;
  Pose mount_ = Pose::Identity();               ///< the sensor frame in the flange frame
  std::optional<Eigen::Matrix3d> orientation_;  ///< of the sensor frame in the base frame
  Wrench bias_ = Wrench::Zero();
};

}  // namespace mrroc::vsp
