#pragma once

#include <map>
#include <memory>
#include <string>

#include "links/transport/domain.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::links {

/// The telemetry of all processes of a deployment, for operators: it looks when it is asked and wakes no one. One
/// thread; it allocates.
class StatusCollector {
 public:
  struct Process {
    ProcessStatus status;  ///< the last that came
    bool alive = true;     ///< false once its publisher has ended or has been silent for the lease
  };

  /// Throws SystemError: a bad topic name (configuration), what DDS refuses (resources).
  StatusCollector(Domain& domain, const std::string& deployment);
  ~StatusCollector();

  /// Takes in what has come since the last call. Does not wait.
  void poll();
  /// Every process heard of so far, by name.
  const std::map<std::string, Process>& processes() const noexcept { return processes_; }
  /// Statuses that could not be trusted.
  std::uint64_t malformed() const noexcept { return malformed_; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::map<std::string, Process> processes_;
  std::uint64_t malformed_ = 0;
};

}  // namespace mrroc::links
