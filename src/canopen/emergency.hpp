#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "can/frame.hpp"
#include "canopen/identifiers.hpp"

namespace mrroc::canopen {

/// The error code of a node that has lost a heartbeat which it watches (CiA 301, table 26).
inline constexpr std::uint16_t kHeartbeatError = 0x8130;

/// A node's emergency message (CiA 301, 7.2.7): the error code of 603Fh, 0 when all errors have cleared.
struct Emergency {
  NodeId node = 0;
  std::uint16_t code = 0;
  std::uint8_t error_register = 0;
  std::array<std::uint8_t, 5> manufacturer{};
};

/// The emergency in a frame; nothing: another kind of frame. Never throws.
std::optional<Emergency> emergency_of(const can::Frame& frame) noexcept;

can::Frame to_frame(const Emergency& emergency);

/// The meaning of an error code (CiA 301, table 26; CiA 402-2, 5.3): the text of the code itself, else that of its
/// group, "a manufacturer's error" for FFxxh. Any thread; never throws.
std::string_view error_text(std::uint16_t code) noexcept;

}  // namespace mrroc::canopen
