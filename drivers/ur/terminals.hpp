#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/ur/rtde/value.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::ur {

/// The digital terminals of a controller are bits of one word in RTDE: standard ones 0 to 7, configurable ones 8 to 15,
/// those of the tool's connector 16 and 17. A robot of MRROC++ has 16, so the two of the tool take the numbers
/// `tool_terminals` and the next one from two others (0 to 14); -1: they have none.
inline constexpr int kNoToolTerminals = -1;

/// The bits of the two numbers that the tool's terminals have.
constexpr std::uint16_t tool_mask(int tool_terminals) noexcept {
  return tool_terminals < 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(3U << tool_terminals);
}

/// The robot's terminals 0 to 15 of the controller's `bits`.
constexpr std::uint16_t as_numbered(std::uint64_t bits, int tool_terminals) noexcept {
  const auto others = static_cast<std::uint16_t>(bits & 0xffffU & ~std::uint64_t{tool_mask(tool_terminals)});
  if (tool_terminals < 0) return others;
  return static_cast<std::uint16_t>(others | (bits >> 16U & 3U) << tool_terminals);
}

/// The controller's bits of the robot's terminals; those whose numbers the tool's have taken are off.
constexpr std::uint64_t as_reported(std::uint16_t numbered, int tool_terminals) noexcept {
  const std::uint64_t others = numbered & ~std::uint64_t{tool_mask(tool_terminals)};
  if (tool_terminals < 0) return others;
  return others | std::uint64_t{numbered >> tool_terminals & 3U} << 16U;
}

/// Fields of the recipe that sets the terminals; those of the tool only where they have numbers, because older
/// controllers do not know them.
std::vector<std::string> terminal_fields(int tool_terminals);
/// Their values; `values` has as many elements. Allocates nothing.
void write_terminals(const ControllerIo& outputs, int tool_terminals, std::span<rtde::Value> values) noexcept;

inline constexpr double kAnalogRange = 10;  ///< V, of the controller's analogue terminals

}  // namespace mrroc::ur
