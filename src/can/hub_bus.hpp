#pragma once

#include <vector>

#include "can/bus.hpp"

namespace mrroc::can {

/// A participant of a `Hub`: frames in the format of the kernel's CAN sockets over a Unix socket, for machines whose
/// kernel has no CAN.
class HubBus : public Bus {
 public:
  /// Throws std::runtime_error: no hub listens at `path`.
  explicit HubBus(const std::string& path);
  ~HubBus() override;
  HubBus(const HubBus&) = delete;
  HubBus& operator=(const HubBus&) = delete;

  Sent send(const Frame& frame) noexcept override;
  bool receive(Frame& frame, std::int64_t deadline) noexcept override;
  void filter(std::span<const Filter> filters) override { filters_.assign(filters.begin(), filters.end()); }
  bool carries_fd() const noexcept override { return true; }
  int descriptor() const noexcept override { return socket_; }

 private:
  bool wanted(const Frame& frame) const noexcept;

  int socket_ = -1;
  std::vector<Filter> filters_{{0, 0}};
};

}  // namespace mrroc::can
