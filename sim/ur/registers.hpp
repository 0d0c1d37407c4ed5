#pragma once

#include <array>
#include <cstdint>

namespace mrroc::sim::ur {

inline constexpr int kRegisters = 48;

/// General-purpose registers of a controller: inputs are written by RTDE clients, outputs by programs.
struct Registers {
  std::array<std::int32_t, kRegisters> integer_inputs{}, integer_outputs{};
  std::array<double, kRegisters> real_inputs{}, real_outputs{};
};

}  // namespace mrroc::sim::ur
