#pragma once

#include <cstdint>
#include <vector>

#include "can/frame.hpp"

namespace mrroc::can {

/// Bits of a classical data frame on the wire with its own stuff bits and the space between frames (ISO 11898-1).
inline int frame_length(const Frame& frame) {
  constexpr unsigned kPolynomial = 0x4599, kCrcBits = 15;
  constexpr int kUnstuffed = 13;  // CRC delimiter, ACK, end of frame, intermission
  std::vector<bool> bits{false};  // start of frame
  const auto append = [&bits](unsigned value, unsigned count) {
    for (unsigned i = count; i-- > 0;) bits.push_back((value >> i & 1) != 0);
  };
  append(frame.id, 11);
  append(0, 3);  // RTR, IDE, r0
  append(frame.size, 4);
  for (const std::uint8_t byte : frame.bytes()) append(byte, 8);
  unsigned crc = 0;
  for (const bool bit : bits) {
    const bool next = bit != ((crc >> (kCrcBits - 1) & 1) != 0);
    crc = crc << 1 & 0x7fff;
    if (next) crc ^= kPolynomial;
  }
  append(crc, kCrcBits);
  int length = 0, run = 0;
  bool last = !bits.front();
  for (const bool bit : bits) {
    run = bit == last ? run + 1 : 1;
    last = bit;
    ++length;
    if (run < 5) continue;
    ++length;  // a stuff bit of the other value
    last = !bit;
    run = 1;
  }
  return length + kUnstuffed;
}

}  // namespace mrroc::can
