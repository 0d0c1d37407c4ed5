#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "links/transport/domain.hpp"

namespace mrroc::links {

/// A watcher of a `TelemetryPublisher` of <T>. It is polled and wakes no thread. One thread.
template <class T>
class TelemetryReader {
 public:
  /// `topic` as of the publisher. Throws as it does.
  TelemetryReader(Domain& domain, const std::string& topic);
  ~TelemetryReader();

  /// The newest message since the last call; false when none has arrived. Malformed ones are dropped. Never waits.
  bool take(T& message);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
