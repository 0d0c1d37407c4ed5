#pragma once

#include <cstdint>

namespace mrroc::kinematics {

/// The next number in [0, 1) of splitmix64: the same ones for every call and machine.
inline double next_uniform(std::uint64_t& state) noexcept {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
  z = (z ^ z >> 27) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
}

}  // namespace mrroc::kinematics
