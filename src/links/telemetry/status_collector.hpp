#pragma once

#include <map>
#include <memory>
#include <string>

#include "links/transport/domain.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::links {

/// The telemetry of all processes of a deployment, for operators. It is polled and wakes no thread. One thread; it
/// allocates.
class StatusCollector {
 public:
  struct Process {
    ProcessStatus status;  ///< the last one received
    bool alive = true;     ///< false once its publisher has ended or has been silent for the lease
  };

  /// Throws SystemError: a bad topic name (configuration), an error of DDS (resources).
  StatusCollector(Domain& domain, const std::string& deployment);
  ~StatusCollector();

  /// Takes the statuses that have arrived since the last call. Does not wait.
  void poll();
  /// Every process seen so far, by name.
  const std::map<std::string, Process>& processes() const noexcept { return processes_; }
  /// Number of refused statuses.
  std::uint64_t malformed() const noexcept { return malformed_; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::map<std::string, Process> processes_;
  std::uint64_t malformed_ = 0;
};

}  // namespace mrroc::links
