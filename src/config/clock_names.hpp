#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/deployment.hpp"

namespace mrroc::config {

/// In the order of ClockMode.
inline constexpr std::array<const char*, 3> kClockNames{"real", "paced", "lockstep"};

constexpr const char* name_of(ClockMode clock) noexcept { return kClockNames[static_cast<std::size_t>(clock)]; }

inline std::vector<std::string> clock_names() { return {kClockNames.begin(), kClockNames.end()}; }

/// Empty for another text.
constexpr std::optional<ClockMode> clock_named(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kClockNames.size(); ++i)
    if (name == kClockNames[i]) return static_cast<ClockMode>(i);
  return std::nullopt;
}

}  // namespace mrroc::config
