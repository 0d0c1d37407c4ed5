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

/// A CAN bus without a kernel that has one: a Unix socket (SOCK_SEQPACKET) whose clients exchange `struct can_frame`
/// (16 bytes) and, of CAN FD, `struct canfd_frame` (72 bytes). What one sends, all get who have connected before, but
/// itself, in the order in which the hub has read it. A client that does not read loses frames once its socket is full,
/// as a controller's receive buffer overruns. It has a thread of its own.
class Hub {
 public:
  /// What becomes of a frame: passed on as it is or changed; false: lost. For tests of faults; the hub's thread.
  using Disturbance = std::function<bool(Frame& frame)>;

  /// Listens at `path`, where no other hub may be and nothing but what a killed one has left. Throws
  /// std::runtime_error.
  explicit Hub(std::filesystem::path path, Disturbance disturbance = {});
  /// Ends the bus: its clients see it gone.
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// "unix:PATH", as `open_bus` takes it.
  std::string name() const { return "unix:" + listener_.path().string(); }
  /// How many it has passed on. Any thread.
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
