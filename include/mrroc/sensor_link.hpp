#pragma once

#include <array>

#include "mrroc/parcel.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// Maximum number of values in one reading.
inline constexpr std::size_t kMaxChannels = 16;

/// v^i of one virtual sensor: the header and the values of its declared channels (names and units: `VirtualSensor`).
/// Its time-stamp is `tick`, its status `error`; its age is `Sensor::age()`.
struct SensorReading {
  std::uint64_t sequence = 0;  ///< counts readings of this VSP since its start, from 1
  Tick tick = 0;               ///< tick of the hardware reading that was aggregated
  /// The configuration with which it was made (`Sensor::configure`): counts those that the VSP has taken, from 0, that
  /// of the deployment.
  std::uint32_t configuration = 0;
  std::uint32_t channel_count = 0;
  std::array<double, kMaxChannels> values{};
  ErrorReport error;
};

/// A client's request to an interactive virtual sensor.
enum class SensorRequestKind : std::uint8_t {
  reading = 0,   ///< aggregate at `measure_at` and reply
  bias = 1,      ///< take the present reading as zero, then reply with the new reading
  configure = 2  ///< work with `configuration` from the next reading on; the reply has no values
};

struct SensorRequest {
  SensorRequestKind kind = SensorRequestKind::reading;
  /// The tick of the requested hardware reading; at once when it has passed.
  Tick measure_at = 0;
  Message configuration{};  ///< of `configure`
};

/// The connection from a `Sensor` to its VSP, or to a test's fake. Called by the task's thread only.
class SensorLink {
 public:
  virtual ~SensorLink() = default;
  /// Sends a request; does not wait.
  virtual void request(const SensorRequest& request) = 0;
  /// Waits for the reply to the last `request`. Throws SystemError when the VSP died or is silent.
  virtual void receive(SensorReading& reading) = 0;
  /// Whether the deployment has this sensor polled: readings are requested but never waited for.
  virtual bool polled() const noexcept { return false; }
  /// Stores the reply to the last `request` if it has arrived; otherwise returns false and leaves `reading` unchanged.
  /// Never waits. Throws as `receive`.
  virtual bool poll(SensorReading& /*reading*/) { return false; }
  /// The newest published reading (non-interactive); never waits. False before the first one.
  virtual bool latest(SensorReading& reading) = 0;
};

}  // namespace mrroc
