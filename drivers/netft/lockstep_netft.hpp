#pragma once

#include "drivers/netft/netft_source.hpp"
#include "drivers/netft/socket.hpp"

namespace mrroc::netft {

/// The stand-in of a Net F/T in lockstep: `read` requests one record and waits for that of the wanted tick, which its
/// count of measurements identifies. The world stands still meanwhile, so a request that the network has lost is
/// repeated without another outcome.
///
/// silent: no record within kTimeout of wall time, or the stand-in has ended; until the end of the run. faulty: the
/// status word of the record makes its counts invalid.
class LockstepNetft final : public vsp::Source {
 public:
  static constexpr std::int64_t kTimeout = 10'000'000'000;  ///< ns

  /// The load at tick 0 becomes the sensor's zero where the options say so. `period` of the servo, s. Main thread.
  /// Throws HardwareError(sensor_hardware) for an address without a route and a stand-in that does not take its zero,
  /// std::system_error when there is no socket.
  LockstepNetft(const NetftOptions& options, const Calibration& calibration, double period);

  vsp::SourceState read(Tick wanted, vsp::RawReading& raw) noexcept override;
  std::string_view fault() const noexcept override { return fault_.view(); }

 private:
  void set_bias(const NetftOptions& options);
  bool measure(Tick tick) noexcept;
  bool request(const Request& request) noexcept;
  bool receive(Tick tick, std::int64_t deadline) noexcept;

  const Calibration calibration_;
  const double period_;
  Descriptor socket_;
  Record record_;
  bool refused_ = false;  ///< the stand-in has ended
  bool lost_ = false;
  NetftFault fault_;
};

}  // namespace mrroc::netft
