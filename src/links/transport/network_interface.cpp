#include "links/transport/network_interface.hpp"

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

/// A device, or one of its IPv4 addresses.
struct Entry {
  NetworkInterface interface;  ///< its address is empty where the entry is of the device alone
  bool up = false;
};

/// Every device and every IPv4 address of this machine, up or down, in the kernel's order.
std::vector<Entry> list_entries() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) {
    throw SystemError(ErrorCode::resources, std::string{"network interfaces: "} + std::strerror(errno));
  }
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> owner(list, &::freeifaddrs);
  std::vector<Entry> entries;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    // an alias such as eth0:1 is an address of the device eth0
    std::string device = entry->ifa_name;
    device = device.substr(0, device.find(':'));
    char text[INET_ADDRSTRLEN] = "";
    if (entry->ifa_addr != nullptr && entry->ifa_addr->sa_family == AF_INET) {
      // of a point-to-point device this is the own address; the peer's is in ifa_dstaddr
      ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr, text, sizeof text);
    }
    const bool loopback = (entry->ifa_flags & IFF_LOOPBACK) != 0;
    entries.push_back({{device, text, ::if_nametoindex(device.c_str()), loopback}, (entry->ifa_flags & IFF_UP) != 0});
  }
  return entries;
}

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw SystemError(ErrorCode::configuration, "network interface '" + name + "'" + problem);
}

}  // namespace

NetworkInterface find_interface(const std::string& name) {
  constexpr const char* kUsual = "127.0.0.1";
  const std::vector<Entry> entries = list_entries();
  std::string known;
  const NetworkInterface* found = nullptr;
  const Entry* unusable = nullptr;
  for (const Entry& entry : entries) {
    const NetworkInterface& interface = entry.interface;
    const bool meant = name.empty() ? interface.loopback : interface.device == name || interface.address == name;
    const bool usable = entry.up && !interface.address.empty() && interface.index != 0;
    if (meant && usable && (found == nullptr || (name.empty() && interface.address == kUsual))) found = &interface;
    if (meant && !usable) unusable = &entry;
    if (usable) known += (known.empty() ? "" : ", ") + interface.device + " (" + interface.address + ")";
  }
  if (found != nullptr) return *found;
  if (unusable != nullptr) {
    const std::string& device = unusable->interface.device;
    if (!unusable->up) refuse(device, " is down, expected up: `ip link set " + device + " up`");
    refuse(device, " has no IPv4 address, expected one");
  }
  refuse(name.empty() ? "lo" : name,
         ": expected a device or an own address, one of " + (known.empty() ? "none" : known));
}

}  // namespace mrroc::links
