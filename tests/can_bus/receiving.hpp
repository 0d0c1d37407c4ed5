#pragma once

#include <optional>
#include <vector>

#include "can/bus.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::test {

inline constexpr std::int64_t kLong = 20 * clock::kSecond;  ///< only failing tests take this long

/// Waits for the next frame; nothing: there is none in time.
inline std::optional<can::Frame> next_frame(can::Bus& bus, std::int64_t patience = kLong) {
  can::Frame frame;
  if (!bus.receive(frame, clock::monotonic_ns() + patience)) return {};
  return frame;
}

/// All frames up to the one with the identifier `last`.
inline std::vector<can::Frame> frames_until(can::Bus& bus, std::uint32_t last) {
  std::vector<can::Frame> frames;
  for (auto frame = next_frame(bus); frame && frame->id != last; frame = next_frame(bus)) frames.push_back(*frame);
  return frames;
}

}  // namespace mrroc::test
