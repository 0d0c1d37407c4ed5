#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrroc::cli {

/// The key shared by the two ends of a link between hosts; the far end receives it through its control channel.
using HeartbeatKey = std::array<std::uint8_t, 32>;

/// The datagram that two hosts keep sending each other: a sign of life, and the times from which each estimates the
/// other's clock.
struct Heartbeat {
  bool from_runner = false;    ///< so that a reflected beat is rejected
  std::uint64_t sequence = 0;  ///< increases with every beat of a side
  std::int64_t sent = 0;       ///< CLOCK_MONOTONIC of its sender, ns
  std::int64_t echo = 0;       ///< `sent` of the newest beat that the sender had received; 0: none yet
  std::int64_t held = 0;       ///< ns since it received that beat
  // of the runner's emergency stop (clock::EmergencyStop); the runner ignores those of an agent
  std::uint32_t presses = 0;
  std::uint32_t resets = 0;
};

/// Random bytes from the kernel. Throws std::runtime_error when the kernel returns none.
HeartbeatKey new_beat_key();

/// The datagram, with a code (HMAC-SHA-256) that only owners of the key can make.
std::vector<std::uint8_t> seal(const Heartbeat& beat, const HeartbeatKey& key);
/// Nothing when the datagram is not a beat or was not sealed with this key, whatever its bytes.
std::optional<Heartbeat> open(const std::uint8_t* data, std::size_t size, const HeartbeatKey& key);

std::string to_hex(const HeartbeatKey& key);
/// Nothing when the text is not a key.
std::optional<HeartbeatKey> key_of_hex(const std::string& text);

}  // namespace mrroc::cli
