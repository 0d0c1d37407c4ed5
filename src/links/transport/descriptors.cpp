#include "links/transport/descriptors.hpp"

#include <fcntl.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include "links/cyclone/socket_limit.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw SystemError(ErrorCode::resources, "DDS sockets: " + what); }

}  // namespace

std::set<int> open_descriptors() {
  std::set<int> descriptors;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int fd = std::stoi(entry.path().filename());
    descriptors.insert(fd);
  }
  // the directory's own descriptor is closed by now
  std::erase_if(descriptors, [](int fd) { return ::fcntl(fd, F_GETFD) < 0; });
  return descriptors;
}

bool is_udp_socket(int fd) {
  int domain = 0;
  int type = 0;
  socklen_t size = sizeof(int);
  if (::getsockopt(fd, SOL_SOCKET, SO_DOMAIN, &domain, &size) != 0) return false;
  if (::getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &size) != 0) return false;
  return (domain == AF_INET || domain == AF_INET6) && type == SOCK_DGRAM;
}

void seal_descriptors(const std::set<int>& before) {
  for (const int fd : open_descriptors()) {
    if (before.contains(fd)) continue;
    const int flags = ::fcntl(fd, F_GETFD);
    if (flags < 0 || ::fcntl(fd, F_SETFD, flags | FD_CLOEXEC) != 0) {
      refuse(std::string{"cannot be closed on exec: "} + std::strerror(errno));
    }
    if (is_udp_socket(fd) && !is_limited(fd)) refuse("one is not limited to an interface");
  }
}

}  // namespace mrroc::links
