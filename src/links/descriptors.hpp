#pragma once

#include <set>

namespace mrroc::links {

/// Every descriptor that this process has open.
std::set<int> open_descriptors();

/// Makes every descriptor that is open now but is not in `before` close on exec; Cyclone's are inherited otherwise, and
/// a child would keep its ports occupied. With `loopback_only` the UDP sockets among them are bound to the device `lo`:
/// Cyclone binds them to 0.0.0.0 whatever interface it is given. Throws SystemError when the system refuses.
void seal_descriptors(const std::set<int>& before, bool loopback_only);

/// Whether `fd` is an IPv4 or IPv6 datagram socket.
bool is_udp_socket(int fd);

}  // namespace mrroc::links
