#pragma once

#include <array>
#include <cstdint>

#include "mrroc/types.hpp"

namespace mrroc::vsp {

/// Most values that one hardware sensor gives.
inline constexpr std::size_t kMaxRawValues = 16;

/// r of the paper's equation (14): what the hardware of one sensor gave at `tick`. The values are those of
/// `VirtualSensor::raw_channels()`, in that order.
struct RawReading {
  Tick tick = 0;
  std::uint32_t count = 0;
  std::array<double, kMaxRawValues> values{};
};

}  // namespace mrroc::vsp
