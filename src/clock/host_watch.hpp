#pragma once

#include "clock/clock_memory.hpp"

namespace mrroc::clock {

/// How the process is that owns the deployment's clock and watches over its participants. Of one that is stopped they
/// stop the robots, as whoever has started it may not be able to kill it, over ssh.
enum class HostLife {
  alive,    ///< or held by a debugger
  stopped,  ///< by a signal (SIGSTOP), under the real clock
  lost      ///< it has died
};

/// What a participant asks the kernel about its host. Its thread only.
class HostWatch {
 public:
  /// `memory` must outlive it. Throws SystemError when the host has died already.
  explicit HostWatch(const ClockMemory& memory);
  ~HostWatch();
  HostWatch(const HostWatch&) = delete;
  HostWatch& operator=(const HostWatch&) = delete;

  /// Two system calls, no allocation; never waits.
  HostLife look() noexcept;

 private:
  char state() const noexcept;

  const ClockMemory& memory_;
  int process_;    // pidfd
  int stat_ = -1;  // its `stat` of proc(5), which stays its own whoever gets its number
};

}  // namespace mrroc::clock
