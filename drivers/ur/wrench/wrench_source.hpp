#pragma once

#include <cstdint>
#include <memory>

#include "clock/clock.hpp"
#include "drivers/ur/wrench/wrench_client.hpp"
#include "vsp/source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::ur {

/// The wrench that a UR controller measures or estimates, as the hardware of a sensor of the type `force_torque`: r is
/// the wrench s with which the wrist supports the tool (N, N m), the negative of `load_on_sensor`. The controller has
/// taken the payload's weight out of it. A reading's tick is that of its arrival on the clock's grid.
///
/// In lockstep with a stand-in a reading is that of the wanted tick, for which `read` waits.
///
/// silent: no package for `timeout`, in lockstep for kLockstepTimeout of wall time.
class UrWrenchSource final : public vsp::Source {
 public:
  /// Waits for the first package. `clock` outlives the source; `options.lockstep` is its `simulated()`. `servo_period`
  /// in s. Throws as WrenchClient.
  UrWrenchSource(const WrenchOptions& options, const Pose& mount, const clock::Clock& clock, double servo_period);

  vsp::SourceState read(Tick wanted, vsp::RawReading& raw) noexcept override;
  /// Any thread.
  WrenchCounters counters() const noexcept { return client_.counters(); }

 private:
  Tick tick_of(std::int64_t arrival_ns) const noexcept;
  vsp::SourceState await(Tick wanted, vsp::RawReading& raw) noexcept;
  void fill(const MeasuredWrench& newest, vsp::RawReading& raw) const noexcept;

  const clock::Clock* clock_;
  const Pose mount_;
  std::int64_t period_ns_;
  Tick silent_after_;
  const double period_;  ///< s
  const bool lockstep_;
  bool lost_ = false;  ///< in lockstep
  WrenchClient client_;
};

/// The source of a deployment's sensor inside the controller of its robot. At its end it reports on stderr the packages
/// that were lost or disturbed. Throws HardwareError(sensor_hardware) that names address and problem, and
/// SystemError(configuration) for keys of the sensor that do not fit: a calibration, a tool_mass.
std::unique_ptr<vsp::Source> open_ur_wrench(const vsp::SourceContext& context);

}  // namespace mrroc::ur
