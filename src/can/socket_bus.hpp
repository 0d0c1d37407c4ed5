#pragma once

#include "can/bus.hpp"

namespace mrroc::can {

/// A raw socket on a CAN interface of the kernel (Linux, Documentation/networking/can.rst). It receives frames of other
/// sockets on the same machine, not its own, and every error that the controller reports. An interface set up for CAN
/// FD (`ip link`: mtu 72) carries frames of both kinds.
class SocketBus : public Bus {
 public:
  /// Throws std::runtime_error: the kernel does not support CAN, the interface is missing, is down or is not a CAN
  /// interface.
  explicit SocketBus(const std::string& interface);
  ~SocketBus() override;
  SocketBus(const SocketBus&) = delete;
  SocketBus& operator=(const SocketBus&) = delete;

  Sent send(const Frame& frame) noexcept override;
  bool receive(Frame& frame, std::int64_t deadline) noexcept override;
  void filter(std::span<const Filter> filters) override;
  bool carries_fd() const noexcept override { return fd_; }
  int descriptor() const noexcept override { return socket_; }

 private:
  int socket_ = -1;
  bool fd_ = false;
};

}  // namespace mrroc::can
