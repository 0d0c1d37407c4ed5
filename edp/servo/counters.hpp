#pragma once

#include "mrroc/types.hpp"

namespace mrroc::edp {

/// What the servo counts, always on, since start.
struct ServoCounters {
  std::uint64_t ticks = 0;      ///< executed
  std::uint64_t missed = 0;     ///< ticks of the grid that were not executed
  std::uint64_t stops = 0;      ///< times the robot braked because no successor had come
  JointVector following_error;  ///< largest |desired - measured| of each motor while enabled, rad
};

/// What the comms side counts since start.
struct CommandCounters {
  std::uint32_t accepted = 0;
  std::uint32_t refused = 0;    ///< answered by an error at once
  std::uint32_t late = 0;       ///< came after the robot had begun to brake, planned from an outdated state
  std::uint32_t stretched = 0;  ///< late ones whose duration had to grow to stay within the limits
};

}  // namespace mrroc::edp
