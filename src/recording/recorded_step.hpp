#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::recording {

/// A step on its way to a recording.
struct RecordedStep {
  Tick tick = 0;               ///< at which the process made it
  std::vector<std::byte> cdr;  ///< mrroc_msgs/msg/Step
};

/// What a process that has ended in order has passed on.
struct StepCounts {
  std::uint64_t added = 0;
  std::uint64_t dropped = 0;  ///< for want of room
};

}  // namespace mrroc::recording
