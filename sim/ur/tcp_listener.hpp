#pragma once

#include <string>
#include <utility>

namespace mrroc::sim::ur {

/// A non-blocking TCP socket that accepts connections at the IPv4 address, and its port; port 0 takes a free one. The
/// caller closes it. Throws std::system_error with address and port.
std::pair<int, int> open_listener(const std::string& address, int port);

}  // namespace mrroc::sim::ur
