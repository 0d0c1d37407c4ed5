#pragma once

#include <cstdint>

namespace mrroc::links {

/// The header of every message.
struct Header {
  std::uint64_t sequence = 0;  ///< chosen by the sender; a reply carries that of its request
  std::uint64_t boot = 0;      ///< of the sending process: `Domain::boot`
  std::uint64_t answers = 0;   ///< boot of the process whose request this answers; 0: not an answer
  std::uint64_t delta = 0;     ///< `clock::Clock::delta` of the sender
  /// Time since tick 0, so that it means the same on every host of the deployment; before the start CLOCK_MONOTONIC of
  /// the sender's. 0 under simulated time.
  std::int64_t stamp_ns = 0;
};

}  // namespace mrroc::links
