#pragma once

#include <memory>
#include <string>
#include <vector>

#include "links/exchange/caller.hpp"
#include "links/exchange/responder.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {

/// The VSP's end of its clients' `SensorRequester`s. The participant's thread calls it.
class SensorResponder {
 public:
  /// `clients`: names of the processes that use the sensor, in the order in which they are served. With `published`
  /// readings are published too.
  SensorResponder(Domain& domain, clock::Clock& clock, const std::string& prefix,
                  const std::vector<std::string>& clients, bool published);

  /// A request not yet taken, of the first client that has one; false when there is none. Does not wait.
  bool take(SensorRequest& request, Caller& caller);
  /// Answers the request that the client made last; false, without sending, when another request has overtaken it.
  bool reply(const SensorReading& reading, const Caller& caller);
  /// Sends a reading to every client that reads published readings. Throws SystemError when it was constructed without
  /// them.
  void publish(const SensorReading& reading);

  std::size_t client_count() const noexcept { return clients_.size(); }
  bool peer_alive(std::size_t client) const { return clients_.at(client)->peer_alive(); }
  /// Dropped requests of a client, by reason.
  ReaderCounters counters(std::size_t client) const { return clients_.at(client)->counters(); }

 private:
  std::unique_ptr<Writer<SensorReading>> published_;
  std::vector<std::unique_ptr<Responder<SensorRequest, SensorReading>>> clients_;
  std::uint64_t publications_ = 0;
};

}  // namespace mrroc::links
