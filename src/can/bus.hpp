#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "can/frame.hpp"

namespace mrroc::can {

/// The result of sending a frame.
enum class Sent : std::uint8_t {
  yes,
  full,  ///< the transmit queue is full: no node acknowledges, or the bus is overloaded
  down   ///< the interface is down or gone, or does not carry this CAN FD frame
};

/// Identifiers that a bus receives: those with (id & mask) == (wanted & mask).
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
  /// The next frame; waits for it until `deadline` (CLOCK_MONOTONIC, ns; in the past: does not wait). False: no frame.
  virtual bool receive(Frame& frame, std::int64_t deadline) noexcept = 0;
  /// Receives from now on only these and error frames. Throws std::system_error. Not on the real-time path.
  virtual void filter(std::span<const Filter> filters) = 0;
  /// Whether CAN FD frames can be sent; otherwise only classical ones.
  virtual bool carries_fd() const noexcept = 0;
  /// Becomes readable when a frame has arrived.
  virtual int descriptor() const noexcept = 0;
};

/// Opens a bus by name: a network interface of the kernel ("can0"), or "unix:PATH", the socket of a `Hub`. Waits for
/// neither. Throws std::runtime_error with the name and the problem.
std::unique_ptr<Bus> open_bus(const std::string& name);

}  // namespace mrroc::can
