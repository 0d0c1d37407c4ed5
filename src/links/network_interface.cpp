#include "links/network_interface.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

/// Every IPv4 address of a device that is up, in the kernel's order.
std::vector<NetworkInterface> interfaces_up() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) {
    throw SystemError(ErrorCode::resources, std::string{"network interfaces: "} + std::strerror(errno));
  }
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> owner(list, &::freeifaddrs);
  std::vector<NetworkInterface> found;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET || (entry->ifa_flags & IFF_UP) == 0)
      continue;
    char text[INET_ADDRSTRLEN] = "";
    ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr, text, sizeof text);
    // an alias such as eth0:1 is an address of the device eth0
    std::string device = entry->ifa_name;
    device = device.substr(0, device.find(':'));
    found.push_back({device, text, ::if_nametoindex(device.c_str()), (entry->ifa_flags & IFF_LOOPBACK) != 0});
  }
  return found;
}

}  // namespace

NetworkInterface find_interface(const std::string& name) {
  std::string known;
  for (const NetworkInterface& interface : interfaces_up()) {
    const bool meant = name.empty() ? interface.loopback : interface.device == name || interface.address == name;
    if (meant && interface.index != 0) return interface;
    known += (known.empty() ? "" : ", ") + interface.device + " (" + interface.address + ")";
  }
  throw SystemError(ErrorCode::configuration, "network interface '" + (name.empty() ? "lo" : name) +
                                                  "': expected a device or an own address, one of " +
                                                  (known.empty() ? "none" : known));
}

}  // namespace mrroc::links
