#pragma once

#include <linux/can.h>

#include <algorithm>

#include "can/frame.hpp"

namespace mrroc::can {

/// The kernel's `struct can_frame`, which sockets and hubs carry.
inline can_frame to_raw(const Frame& frame) noexcept {
  can_frame raw{};
  raw.can_id = frame.id | (frame.remote ? CAN_RTR_FLAG : 0) | (frame.error ? CAN_ERR_FLAG : 0);
  raw.len = std::min<std::uint8_t>(frame.size, kMaxData);
  std::copy_n(frame.data.begin(), kMaxData, raw.data);
  return raw;
}

/// False: a frame of the extended format, which CANopen does not use.
inline bool from_raw(const can_frame& raw, Frame& frame) noexcept {
  if ((raw.can_id & CAN_EFF_FLAG) != 0) return false;
  frame.error = (raw.can_id & CAN_ERR_FLAG) != 0;
  frame.remote = (raw.can_id & CAN_RTR_FLAG) != 0;
  frame.id = raw.can_id & (frame.error ? CAN_ERR_MASK : CAN_SFF_MASK);
  frame.size = std::min<std::uint8_t>(raw.len, kMaxData);
  std::copy_n(raw.data, kMaxData, frame.data.begin());
  return true;
}

}  // namespace mrroc::can
