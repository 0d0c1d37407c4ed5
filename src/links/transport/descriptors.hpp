#pragma once

#include <set>

namespace mrroc::links {

/// Every descriptor that this process has open.
std::set<int> open_descriptors();

/// Makes every descriptor that is open now but is not in `before` close on exec: Cyclone's are inherited otherwise, and
/// a child would keep its ports occupied. Throws SystemError (resources) when the system refuses, or when a UDP socket
/// among them is not limited to an interface (socket_limit.hpp). May be called again for later descriptors.
void seal_descriptors(const std::set<int>& before);

/// Whether `fd` is an IPv4 or IPv6 datagram socket.
bool is_udp_socket(int fd);

}  // namespace mrroc::links
