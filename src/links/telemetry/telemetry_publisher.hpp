#pragma once

#include <memory>
#include <string>

#include "links/transport/domain.hpp"

namespace mrroc::links {

/// The newest <T> of a process for watchers, RobotState or SensorReading: best effort, on one topic, outside of the
/// clock, so that no process waits for it and no trace depends on it. The participant's thread stores, another thread
/// publishes. Nothing is stored or sent while no reader exists.
template <class T>
class TelemetryPublisher {
 public:
  /// `topic`: "<deployment>/<robot or sensor>/telemetry". Throws SystemError: a bad topic name (configuration), an
  /// error of DDS (resources).
  TelemetryPublisher(Domain& domain, const std::string& topic);
  ~TelemetryPublisher();

  /// Whether a reader exists, as of the last `publish`. Any thread; does not wait.
  bool wanted() const noexcept;
  /// The participant's thread, or a servo's. Neither waits, locks nor allocates.
  void store(const T& message) noexcept;
  /// Sends what has been stored since the last call, when a reader exists. One thread, not a real-time one.
  void publish() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
