#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "can/frame.hpp"

namespace mrroc::can {

/// What became of a frame that was to be sent.
enum class Sent : std::uint8_t {
  yes,
  full,  ///< the transmit queue takes no more: no one acknowledges, or more is sent than the bus carries
  down   ///< the interface is down, or gone; or a CAN FD frame, where it carries none
};

/// Identifiers that a bus hands on: those with (id & mask) == (wanted & mask).
struct Filter {
  std::uint32_t wanted = 0;
  std::uint32_t mask = 0x7ff;
};

/// One participant of a CAN bus. After construction it allocates nothing and throws nothing; one thread.
class Bus {
 public:
  virtual ~Bus() = default;
  /// Never waits.
  virtual Sent send(const Frame& frame) noexcept = 0;
  /// The next frame; waits for it until `deadline` (CLOCK_MONOTONIC, ns; in the past: does not wait). False: none.
  virtual bool receive(Frame& frame, std::int64_t deadline) noexcept = 0;
  /// From now on only these are received, and error frames. Throws std::system_error. Not on the real-time path.
  virtual void filter(std::span<const Filter> filters) = 0;
  /// Whether frames of CAN FD can be sent; else only classical ones.
  virtual bool carries_fd() const noexcept = 0;
  /// Becomes readable when a frame has come.
  virtual int descriptor() const noexcept = 0;
};

/// Opens a bus by name: a network interface of the kernel ("can0"), or "unix:PATH", the socket of a `Hub`. Waits for
/// neither. Throws std::runtime_error that names it and says what is wrong.
std::unique_ptr<Bus> open_bus(const std::string& name);

}  // namespace mrroc::can
