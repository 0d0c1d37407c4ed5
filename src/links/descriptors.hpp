#pragma once

#include <set>

#include "links/network_interface.hpp"

namespace mrroc::links {

/// Every descriptor that this process has open.
std::set<int> open_descriptors();

/// Makes every descriptor that is open now but is not in `before` close on exec; Cyclone's are inherited otherwise, and
/// a child would keep its ports occupied. The UDP sockets among them hear `interface` only, though Cyclone binds them
/// to 0.0.0.0 whatever it is told: to the loopback device they are bound; of another one they hear what comes in by it
/// and what this machine sends to itself (`accept_from`). May be called again for later descriptors. Throws SystemError
/// when the system refuses.
void seal_descriptors(const std::set<int>& before, const NetworkInterface& interface);

/// Lets the socket `fd` hear only what comes in by the devices with these kernel numbers: a filter in the kernel drops
/// the rest. Needs no privilege. A socket bound to a device would not hear the processes of its own machine, whose
/// datagrams to its address take the way of the loopback device. Throws SystemError when the system refuses.
void accept_from(int fd, unsigned device, unsigned other);

/// Whether `fd` is an IPv4 or IPv6 datagram socket.
bool is_udp_socket(int fd);

}  // namespace mrroc::links
