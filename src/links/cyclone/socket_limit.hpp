#pragma once

#include "links/transport/network_interface.hpp"

namespace mrroc::links {

/// During its lifetime every socket that Cyclone binds in this thread is limited to `interface` before it has a port,
/// so that no datagram of another device is ever queued. Cyclone always binds its receiving sockets to 0.0.0.0,
/// independent of its configuration. A socket of the loopback interface accepts datagrams that arrive on the loopback
/// device. A socket of another interface accepts those on its device and on the loopback device, where datagrams from
/// other processes of this machine to its own addresses arrive.
///
/// Cyclone (0.10.2) calls its function `ddsrt_bind` for this, which this class replaces. Needs no privilege, unlike
/// SO_BINDTODEVICE, which in addition would exclude the processes of this machine.
class SocketLimit {
 public:
  explicit SocketLimit(const NetworkInterface& interface) noexcept;
  ~SocketLimit();
  SocketLimit(const SocketLimit&) = delete;
  SocketLimit& operator=(const SocketLimit&) = delete;
};

/// Makes the kernel drop every packet for the socket `fd` that arrives on a device other than these two, given by the
/// kernel's numbers (socket(7), SO_ATTACH_FILTER; linux/filter.h, SKF_AD_IFINDEX). False when the kernel refuses, with
/// errno. Any thread.
[[nodiscard]] bool accept_from(int fd, unsigned device, unsigned other) noexcept;

/// Whether the socket `fd` has such a filter.
bool is_limited(int fd) noexcept;

}  // namespace mrroc::links
