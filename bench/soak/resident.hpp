#pragma once

#include <sys/types.h>

#include <map>
#include <string>

namespace mrroc::soak {

/// The resident memory of a process, KiB.
struct Resident {
  /// Cyclone's receive buffers, 1 MiB each. Discovery touches 8 KiB of its buffer every 30 s of wall time, which looks
  /// like a leak for an hour (docs/explanation/soak.md).
  long receive_buffers = 0;
  long others = 0;
  long sum() const noexcept { return receive_buffers + others; }
};

/// The memory of `mrroc run` with this pid, as "runner", and of every process that it has started, by process name.
std::map<std::string, Resident> resident(pid_t runner);

}  // namespace mrroc::soak
