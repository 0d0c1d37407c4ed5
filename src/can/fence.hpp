#pragma once

#include <cstdint>
#include <optional>

#include "can/frame.hpp"

namespace mrroc::can {

/// Orders the frames between a master and its simulated nodes in lockstep: the master sends a fence, and the nodes
/// return it after they have sent all that follows from the frames before it. Frames of one sender arrive in their
/// order, so a returned fence arrives after these answers. It is not part of CANopen, and never on a bus of real nodes.
struct Fence {
  std::uint8_t master = 0;   ///< node number of the sender
  bool ends_cycle = false;   ///< all set-points of this cycle have been sent
  std::uint32_t number = 0;  ///< counts the sender's fences
  friend bool operator==(const Fence&, const Fence&) = default;
};

/// CiA 301 reserves identifiers from 780h on; these two have the lowest priority.
inline constexpr std::uint32_t kFence = 0x7fe;
inline constexpr std::uint32_t kReturnedFence = 0x7ff;

/// A fence as a frame with this identifier, kFence or kReturnedFence.
inline Frame to_frame(const Fence& fence, std::uint32_t id) noexcept {
  Frame frame(id, {fence.master, static_cast<std::uint8_t>(fence.ends_cycle ? 1 : 0)});
  frame.size = 6;
  put(frame.data, 2, 4, fence.number);
  return frame;
}

/// The fence in a frame with this identifier; nothing: another frame.
inline std::optional<Fence> fence_of(const Frame& frame, std::uint32_t id) noexcept {
  if (frame.id != id || frame.size != 6 || frame.error || frame.remote || frame.fd) return std::nullopt;
  return Fence{frame.data[0], frame.data[1] != 0, static_cast<std::uint32_t>(get(frame.bytes(), 2, 4))};
}

}  // namespace mrroc::can
