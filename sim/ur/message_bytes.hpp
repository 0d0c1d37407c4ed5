#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "drivers/ur/rtde/wire.hpp"

namespace mrroc::sim::ur {

/// Appends values in network byte order, as the interfaces for clients send them.
template <class T>
void put(std::vector<std::uint8_t>& bytes, T value) {
  std::array<std::uint8_t, sizeof(T)> memory{};
  mrroc::ur::rtde::WireWriter writer(memory);
  writer.put(value);
  for (const std::uint8_t byte : memory) bytes.push_back(byte);
}

inline void put(std::vector<std::uint8_t>& bytes, bool value) { put(bytes, static_cast<std::uint8_t>(value)); }

template <class T, std::size_t N>
void put(std::vector<std::uint8_t>& bytes, const std::array<T, N>& values) {
  for (const T value : values) put(bytes, value);
}

}  // namespace mrroc::sim::ur
