#pragma once

#include <linux/can.h>

#include <algorithm>
#include <cstddef>

#include "can/frame.hpp"

namespace mrroc::can {

// a CAN FD frame begins with the layout of a classical frame: one structure holds both, and the size distinguishes them
static_assert(offsetof(canfd_frame, len) == offsetof(can_frame, len));
static_assert(offsetof(canfd_frame, data) == offsetof(can_frame, data));

/// A frame in the format of the kernel's sockets and of hubs. Returns its size: CAN_MTU, or CANFD_MTU.
inline std::size_t to_raw(const Frame& frame, canfd_frame& raw) noexcept {
  raw = {};
  raw.can_id = frame.error ? (frame.id & CAN_ERR_MASK) | CAN_ERR_FLAG
                           : (frame.id & CAN_SFF_MASK) | (frame.remote ? CAN_RTR_FLAG : 0);
  raw.len = std::min(frame.size, static_cast<std::uint8_t>(frame.fd ? kMaxData : kMaxClassicalData));
  if (frame.bit_rate_switch && frame.fd) raw.flags = CANFD_BRS;
  std::copy_n(frame.data.begin(), raw.len, raw.data);
  return frame.fd ? CANFD_MTU : CAN_MTU;
}

/// False: wrong size, or the extended format, which CANopen does not use.
inline bool from_raw(const canfd_frame& raw, std::size_t size, Frame& frame) noexcept {
  const bool fd = size == CANFD_MTU;
  if ((!fd && size != CAN_MTU) || (raw.can_id & CAN_EFF_FLAG) != 0) return false;
  frame = {};
  frame.fd = fd;
  frame.bit_rate_switch = fd && (raw.flags & CANFD_BRS) != 0;
  frame.error = (raw.can_id & CAN_ERR_FLAG) != 0;
  frame.remote = !fd && (raw.can_id & CAN_RTR_FLAG) != 0;
  frame.id = raw.can_id & (frame.error ? CAN_ERR_MASK : CAN_SFF_MASK);
  frame.size = std::min(raw.len, static_cast<std::uint8_t>(fd ? kMaxData : kMaxClassicalData));
  std::copy_n(raw.data, frame.size, frame.data.begin());
  return true;
}

}  // namespace mrroc::can
