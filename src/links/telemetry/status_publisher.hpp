#pragma once

#include <memory>
#include <string>

#include "links/transport/domain.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::links {

/// A process's telemetry, on topic `<deployment>/process_status`: the last status of each process is kept for later
/// readers, as long as the process lives. The clock does not count it. One thread, not a servo thread.
class StatusPublisher {
 public:
  /// Throws SystemError: a bad topic name (configuration), an error of DDS (resources).
  StatusPublisher(Domain& domain, const std::string& deployment);
  ~StatusPublisher();

  /// Sends it; never waits. Throws SystemError (link_lost) when DDS refuses it.
  void publish(const ProcessStatus& status);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
