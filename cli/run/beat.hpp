#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrroc::cli {

/// Shared by the two ends of a link between hosts, told to the far one through its control channel.
using BeatKey = std::array<std::uint8_t, 32>;

/// What two hosts send each other all the time: a sign of life, and what the clock of the one looks like from the
/// other.
struct Beat {
  bool from_runner = false;    ///< so that a beat thrown back is none
  std::uint64_t sequence = 0;  ///< grows with every beat of a side
  std::int64_t sent = 0;       ///< CLOCK_MONOTONIC of its sender, ns
  std::int64_t echo = 0;       ///< `sent` of the newest beat that the sender had got; 0: none yet
  std::int64_t held = 0;       ///< how long it had had that one, ns
  // of the runner's emergency stop (clock::EmergencyStop); an agent's are nothing to the runner
  std::uint32_t presses = 0;
  std::uint32_t resets = 0;
};

/// Random bytes of the kernel. Throws std::runtime_error when there are none.
BeatKey new_beat_key();

/// The datagram, with a code (HMAC-SHA-256) that only the key's owners can make.
std::vector<std::uint8_t> seal(const Beat& beat, const BeatKey& key);
/// Nothing when the datagram is no beat or was not sealed with this key, whatever its bytes.
std::optional<Beat> open(const std::uint8_t* data, std::size_t size, const BeatKey& key);

std::string to_hex(const BeatKey& key);
/// Nothing when the text is no key.
std::optional<BeatKey> key_of_hex(const std::string& text);

}  // namespace mrroc::cli
