#pragma once

#include <algorithm>

#include "can/raw_frame.hpp"
#include "fuzz/fuzz.hpp"

namespace fuzz {

namespace can = mrroc::can;

/// The next frame of any kind in `input`; it is what the kernel's form of it gives back.
inline can::Frame take_frame(Bytes& input) {
  canfd_frame raw{};
  const auto kind = input.take<std::uint8_t>();
  raw.can_id = input.take<std::uint16_t>() % 0x800u;
  if ((kind & 7) == 7) raw.can_id |= CAN_ERR_FLAG;
  if ((kind & 7) == 6) raw.can_id |= CAN_RTR_FLAG;
  const bool fd = (kind & 8) != 0;
  raw.len = input.take<std::uint8_t>();
  input.take(raw.data, std::min<std::size_t>(raw.len, fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN));
  can::Frame frame;
  require(can::from_raw(raw, fd ? CANFD_MTU : CAN_MTU, frame), "it is a frame");
  canfd_frame again;
  can::Frame back;
  require(can::from_raw(again, can::to_raw(frame, again), back), "a frame is sent as a frame");
  require(back.size == frame.size && back.data == frame.data, "a frame round-trips");
  return frame;
}

inline void check_sent(const can::Frame& frame) {
  require(frame.id <= 0x7ff && frame.size <= can::kMaxClassicalData && !frame.fd && !frame.error,
          "a sent frame is a classical frame");
}

}  // namespace fuzz
