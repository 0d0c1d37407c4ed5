#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "drivers/netft/calibration.hpp"
#include "drivers/netft/rdt_client.hpp"
#include "vsp/source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::netft {

/// How a client gets its records.
enum class Requests {
  automatic,  ///< polled where the sensor is also a robot's `force_sensor`, else a stream
  stream,     ///< one request: the sensor sends at its own rate, to one client only
  polled      ///< one request per servo period, of one record: the sensor serves several clients
};

/// The keys of a deployment's table [sensors.NAME.netft]: netft.toml, docs/how-to/netft.md.
struct NetftOptions {
  std::string address;  ///< name or IPv4 address
  std::uint16_t port = kRdtPort;
  std::uint16_t http_port = 80;
  std::optional<Calibration> calibration;  ///< nothing: read from the sensor's configuration page
  double timeout = 0.05;                   ///< s without a new measurement after which the sensor is silent
  double start_timeout = 5;                ///< s, for the page and for the first measurement
  double rate_min = 0;                     ///< Hz: smallest rate of the sensor's stream; 0: the servo rate
  Requests requests = Requests::automatic;
  bool set_bias = false;  ///< the load at the start becomes the sensor's zero
};

/// The options from a table's numbers and texts, which have been checked against netft.toml and completed. Throws
/// SystemError(configuration), which names the key of `entry`, for values that contradict each other.
NetftOptions netft_options(const config::SensorEntry& entry, const config::KeyValues& values);

using NetftFault = FixedText<200>;
/// The text of a record whose status makes its counts invalid.
NetftFault fault_of(const Record& record) noexcept;
/// The support forces of a record: `count` and `values` of `raw`.
void fill(const Calibration& calibration, const Record& record, vsp::RawReading& raw) noexcept;

/// An ATI Net F/T as the hardware of a sensor of the type `force_torque`: r is the wrench s with which the wrist
/// supports the tool (N, N m), that is the negative of the load that the Net F/T measures. A reading's tick is that of
/// its arrival on the clock's grid.
///
/// silent: no new measurement for `timeout`. faulty: the status word of the newest record makes its counts invalid; or
/// the sensor has restarted and so has lost the zero that `set_bias` had given it.
class NetftSource final : public vsp::Source {
 public:
  /// Waits for the configuration page and the first measurement, for `start_timeout` each. `clock` outlives the source;
  /// its `simulated()` is false. `servo_period` in s. Throws HardwareError(sensor_hardware) as http_get and RdtClient,
  /// ConfigurationError for a wrong configuration page.
  NetftSource(const NetftOptions& options, const clock::Clock& clock, double servo_period);

  vsp::SourceState read(Tick wanted, vsp::RawReading& raw) noexcept override;
  std::string_view fault() const noexcept override { return fault_.view(); }

  /// Any thread.
  RdtCounters counters() const noexcept { return client_.counters(); }
  const Calibration& calibration() const noexcept { return calibration_; }

 private:
  Tick tick_of(std::int64_t arrival_ns) const noexcept;

  const clock::Clock* clock_;
  std::int64_t period_ns_;
  Tick silent_after_;
  bool biased_;
  Calibration calibration_;
  RdtClient client_;
  NetftFault fault_;
};

/// The source of a deployment's sensor; under simulated time, with a stand-in, LockstepNetft. At its end it reports on
/// stderr the records that were lost or disturbed. Throws as these, and SystemError(configuration) for a sensor whose
/// type, clock or keys do not fit.
std::unique_ptr<vsp::Source> open_netft(const NetftOptions& options, const vsp::SourceContext& context);

}  // namespace mrroc::netft
