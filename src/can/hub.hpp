#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <thread>
#include <vector>

#include "can/frame.hpp"
#include "can/hub_listener.hpp"

namespace mrroc::can {

/// A CAN bus for kernels without CAN: a Unix socket (SOCK_SEQPACKET) whose clients exchange `struct can_frame` (16
/// bytes) and, of CAN FD, `struct canfd_frame` (72 bytes). Each frame is sent to all other clients that have connected
/// before, in the order in which the hub has read it. A client that does not read loses frames when its socket is full,
/// like an overrun of a controller's receive buffer. The hub has its own thread.
class Hub {
 public:
  /// Forwards a frame unchanged or changed; false: lost. For tests of faults; the hub's thread.
  using Disturbance = std::function<bool(Frame& frame)>;

  /// Listens at `path`, where only the socket of a killed hub may exist. Throws std::runtime_error.
  explicit Hub(std::filesystem::path path, Disturbance disturbance = {});
  /// Ends the bus: its clients are disconnected.
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// "unix:PATH", for `open_bus`.
  std::string name() const { return "unix:" + listener_.path().string(); }
  /// Number of forwarded frames. Any thread.
  std::uint64_t frames() const noexcept { return frames_.load(std::memory_order_relaxed); }

 private:
  void serve();
  void accept();
  bool relay(int from);

  Disturbance disturbance_;
  HubListener listener_;
  int stop_;  ///< eventfd
  std::vector<int> clients_;
  std::atomic<std::uint64_t> frames_{0};
  std::thread thread_;
};

}  // namespace mrroc::can
