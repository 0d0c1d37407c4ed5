#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "can/frame.hpp"
#include "cli/can/can_frame_formatter.hpp"

namespace mrroc::cli {

/// Bits that a classical frame takes on the wire, with the pause after it and the largest possible number of stuff bits
/// (Davis, Burns, Bril, Lukkien: "Controller Area Network (CAN) schedulability analysis", Real-Time Systems 35, 2007).
constexpr std::uint64_t bits_on_the_wire(std::size_t bytes) noexcept {
  return 47 + 8 * bytes + (34 + 8 * bytes - 1) / 4;
}

/// Counts frames by identifier. One thread.
class CanSummary {
 public:
  void add(const can::Frame& frame);
  /// A table: number of frames of each kind, their rate, and the largest part of a bus of `bit_rate` (bit/s) that they
  /// take. `seconds`: duration of the listening. CAN FD frames have two bit rates: they count without a load.
  std::string text(const CanFrameFormatter& words, double seconds, double bit_rate) const;

 private:
  struct Count {
    std::uint64_t frames = 0;
    std::uint64_t bits = 0;
  };
  std::map<std::uint32_t, Count> counts_;
  std::uint64_t errors_ = 0;
  std::uint64_t fd_ = 0;
};

}  // namespace mrroc::cli
