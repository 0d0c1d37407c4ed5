#pragma once

#include <cstdint>

namespace mrroc {

/// The limit switches of a robot's axes that are on: bit i is axis i.
struct LimitSwitches {
  std::uint16_t lower = 0;
  std::uint16_t upper = 0;

  bool on_lower(int axis) const noexcept { return ((lower >> axis) & 1u) != 0; }
  bool on_upper(int axis) const noexcept { return ((upper >> axis) & 1u) != 0; }
};

}  // namespace mrroc
