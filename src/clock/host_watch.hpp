#pragma once

#include "clock/clock_memory.hpp"

namespace mrroc::clock {

/// The state of the process that owns the deployment's clock and monitors its participants. If it is stopped, they stop
/// the robots, because its user may not be able to kill it over ssh.
enum class HostLife {
  alive,    ///< or held by a debugger
  stopped,  ///< by a signal (SIGSTOP), under the real clock
  lost      ///< it has died
};

/// A participant's queries to the kernel about its host. Its thread only.
class HostWatch {
 public:
  /// `memory` must outlive it. Throws SystemError when the host has died already.
  explicit HostWatch(const ClockMemory& memory);
  ~HostWatch();
  HostWatch(const HostWatch&) = delete;
  HostWatch& operator=(const HostWatch&) = delete;

  /// Two system calls, no allocation; never waits.
  HostLife poll() noexcept;

 private:
  char state() const noexcept;

  const ClockMemory& memory_;
  int process_;    // pidfd
  int stat_ = -1;  // its `stat` of proc(5), which remains valid when its number is reused
};

}  // namespace mrroc::clock
