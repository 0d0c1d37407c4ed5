#pragma once

#include <array>
#include <cstdint>

#include "mrroc/types.hpp"

namespace mrroc {

/// Most values that one hardware sensor gives.
inline constexpr std::size_t kMaxRawValues = 16;

/// r of the paper's equation (14): the values that the hardware of one sensor gave at `tick`, in the order of
/// `VirtualSensor::raw_channels()`; of a simulated sensor, in the order in which the scene declares them.
struct RawReading {
  Tick tick = 0;
  std::uint32_t count = 0;
  std::array<double, kMaxRawValues> values{};
};

}  // namespace mrroc
