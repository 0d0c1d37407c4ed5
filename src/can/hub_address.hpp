#pragma once

#include <sys/un.h>

#include <stdexcept>
#include <string>

namespace mrroc::can {

/// The address of a hub's socket. Throws std::runtime_error: a path longer than a socket's address may be.
inline sockaddr_un hub_address(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path)
    throw std::runtime_error("CAN hub '" + path + "': " + std::to_string(path.size()) +
                             " characters of path, expected 1 to " + std::to_string(sizeof address.sun_path - 1));
  path.copy(address.sun_path, path.size());
  return address;
}

}  // namespace mrroc::can
