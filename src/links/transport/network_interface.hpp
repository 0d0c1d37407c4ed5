#pragma once

#include <string>

namespace mrroc::links {

/// A network device of this machine and the IPv4 address by which DDS is reached there.
struct NetworkInterface {
  std::string device;   ///< e.g. `eth1`
  std::string address;  ///< e.g. `10.0.0.2`
  unsigned index = 0;   ///< the kernel's number of the device
  bool loopback = false;
};

/// The interface with this name: a device, whose first IPv4 address is used, or one of this machine's own IPv4
/// addresses; empty: the loopback device, with 127.0.0.1 where it has that. The device's flags MULTICAST and
/// POINTOPOINT, its network mask and its MTU do not matter. Throws SystemError (configuration) that names the device
/// when it is down or has no IPv4 address, and otherwise lists the valid names. Any thread.
NetworkInterface find_interface(const std::string& name);

}  // namespace mrroc::links
