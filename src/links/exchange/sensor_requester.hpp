#pragma once

#include <optional>

#include "links/exchange/requester.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {

struct SensorRequesterOptions {
  bool published = false;  ///< reads the published readings too (`latest`)
  bool polled = false;     ///< the value of `polled()`
  Tick timeout = 500;      ///< maximum lateness of a reply, ticks (real time only)
};

/// The link of a `Sensor` to its VSP. Topics: `<prefix>/<client>/request`, `<prefix>/<client>/reading`, and, published
/// for all clients, `<prefix>/published`. Errors and threads: see `Requester`.
class SensorRequester final : public SensorLink {
 public:
  /// `prefix`: "<deployment>/<sensor>"; `client`: this process's name; `peer`: the VSP's name, for errors.
  SensorRequester(Domain& domain, clock::Clock& clock, const std::string& prefix, const std::string& client,
                  std::string peer, SensorRequesterOptions options = {});

  /// Hand-shake with the VSP on all topics, about `timeout` s at most; before the clock starts.
  void connect(double timeout);

  /// The reply is due at `measure_at`, or at once; `timeout` ticks later it is missed.
  void request(const SensorRequest& request) override;
  void receive(SensorReading& reading) override { exchange_.receive(reading); }
  bool polled() const noexcept override { return polled_; }
  bool poll(SensorReading& reading) override { return exchange_.poll(reading); }
  /// False also when `published` is off. Neither waits, locks nor allocates.
  bool latest(SensorReading& reading) override { return published_ && published_->latest(reading); }

  /// Waits until a published reading has arrived, at most until tick `until`. Returns true at once when there was one
  /// before, false when none has arrived or `published` is off. Throws Stopped.
  bool await_published(Tick until);

  bool peer_alive() const noexcept { return exchange_.peer_alive(); }
  std::uint64_t stale_replies() const noexcept { return exchange_.stale_replies(); }
  std::uint64_t malformed_replies() const noexcept { return exchange_.malformed_replies(); }

 private:
  clock::Clock& clock_;
  const Tick timeout_;
  const bool polled_;
  Requester<SensorRequest, SensorReading> exchange_;
  std::optional<Reader<SensorReading>> published_;
};

}  // namespace mrroc::links
