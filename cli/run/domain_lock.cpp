#include "cli/run/domain_lock.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace mrroc::cli {

namespace {
// RTPS ports of domain d begin at 7400 + 250 d: these stay below the kernel's ephemeral ports (32768)
constexpr int kFirstFree = 1;
constexpr int kLastFree = 100;
}  // namespace

DomainLock::DomainLock(int wanted, std::optional<int> avoided) {
  if (wanted >= 0) {
    if (wanted == avoided)
      throw std::runtime_error("DDS domain " + std::to_string(wanted) +
                               " is that of ROS 2, expected another one of the key deployment.domain or ros2.domain");
    if (!take(wanted))
      throw std::runtime_error("DDS domain " + std::to_string(wanted) +
                               " is in use by another deployment on this host, expected a free one: name another "
                               "with the key deployment.domain");
    return;
  }
  for (int domain = kFirstFree; domain <= kLastFree; ++domain) {
    if (domain != avoided && take(domain)) return;
  }
  throw std::runtime_error("no free DDS domain on this host");
}

DomainLock::~DomainLock() {
  if (socket_ >= 0) close(socket_);
}

bool DomainLock::take(int domain) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  // the leading zero makes the name abstract: no file
  const int length = std::snprintf(address.sun_path + 1, sizeof(address.sun_path) - 1, "mrroc-domain-%d", domain);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + static_cast<std::size_t>(length));
  const int candidate = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (candidate < 0) return false;
  if (bind(candidate, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    close(candidate);
    return false;
  }
  socket_ = candidate;
  domain_ = domain;
  return true;
}

}  // namespace mrroc::cli
