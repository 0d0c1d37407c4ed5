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

/// The interface that `name` means: a device (its first IPv4 address) or one of this machine's own IPv4 addresses;
/// empty: the loopback device. Throws SystemError (configuration) that lists what there is. Any thread.
NetworkInterface find_interface(const std::string& name);

}  // namespace mrroc::links
