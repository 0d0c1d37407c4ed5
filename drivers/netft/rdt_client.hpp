#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "core/lockfree/latest_value.hpp"
#include "core/lockfree/shared_slot.hpp"
#include "drivers/netft/rdt.hpp"
#include "drivers/netft/record_sequence.hpp"
#include "drivers/netft/socket.hpp"

namespace mrroc::netft {

/// The RDT server of a sensor and the times of its client, s.
struct RdtOptions {
  std::string address;
  std::uint16_t port = kRdtPort;
  double timeout = 0.05;      ///< without a new measurement, after which the stream is requested again
  double start_timeout = 5;   ///< for the first measurement
  double request_period = 0;  ///< between two requests of one record each; 0: one request of a stream
  bool set_bias = false;      ///< the load at the start becomes the sensor's zero
};

/// A measurement and when it arrived.
struct Measurement {
  Record record;
  std::int64_t arrival_ns = 0;        ///< CLOCK_MONOTONIC
  std::uint64_t sensor_restarts = 0;  ///< of the sensor before it, since the client began
};

struct RdtCounters {
  std::uint64_t records = 0;
  std::uint64_t lost = 0;             ///< records that never came
  std::uint64_t late = 0;             ///< records that a later one had overtaken
  std::uint64_t doubled = 0;          ///< records that had come before
  std::uint64_t malformed = 0;        ///< packets that are not whole records
  std::uint64_t repeated = 0;         ///< records without a new measurement
  std::uint64_t invalid = 0;          ///< records whose status makes their counts invalid
  std::uint64_t requests = 0;         ///< requests of records
  std::uint64_t sensor_restarts = 0;  ///< the sensor's count of measurements has begun again
};

/// "of 7000 records 3 lost, 1 late", with every counter of a disturbance that is not 0; empty: there was none.
std::string disturbances(const RdtCounters& counters);

/// Receives the measurements of a Net F/T by RDT in a thread of its own, which begins and ends with this object; the
/// newest one is handed over without locks. The thread requests the records again while none come, so a sensor that
/// restarts is found again. Packets from other addresses are not received. The thread allocates nothing.
class RdtClient {
 public:
  /// Requests records and waits for the first measurement. Throws HardwareError(sensor_hardware) with the address when
  /// none has come in `start_timeout`, std::system_error when there is no socket or thread.
  explicit RdtClient(const RdtOptions& options);
  /// Asks the sensor to stop.
  ~RdtClient();
  RdtClient(const RdtClient&) = delete;
  RdtClient& operator=(const RdtClient&) = delete;

  /// The newest measurement, whatever its status; unchanged until the next call. One thread; no lock, no allocation.
  const Measurement& newest() noexcept;
  /// Any thread.
  RdtCounters counters() const noexcept;
  /// Makes the present load the sensor's zero, for all its clients; RDT has no answer to it. Any thread.
  void set_bias() noexcept { send({Command::set_bias, 0}); }

 private:
  void await_first();
  void serve() noexcept;
  void request(std::int64_t now) noexcept;
  void send(const Request& request) noexcept;
  void receive() noexcept;
  void take(std::span<const std::uint8_t> packet, std::int64_t now) noexcept;
  void take(const Record& record, std::int64_t now) noexcept;
  bool is_new(const Record& record, std::int64_t now) noexcept;
  void publish_counters() noexcept;

  RdtOptions options_;
  std::int64_t timeout_ns_;
  std::int64_t period_ns_;  ///< 0: a stream
  Descriptor socket_;
  Descriptor end_;  ///< an event that ends the thread
  // the thread's own
  RecordSequence sequence_;
  RdtCounters counted_;
  Measurement newest_;
  bool measured_ = false;
  std::int64_t request_at_ = 0;
  // handed over
  core::LatestValue<Measurement> handed_;
  core::SharedSlot<RdtCounters> counters_;
  std::thread thread_;
};

}  // namespace mrroc::netft
