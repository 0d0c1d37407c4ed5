#include "links/descriptors.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <net/if.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw SystemError(ErrorCode::resources, "DDS sockets: " + what + ": " + std::strerror(errno));
}

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

void accept_from(int fd, unsigned device, unsigned other) {
  constexpr std::uint32_t kDevice = static_cast<std::uint32_t>(SKF_AD_OFF) + SKF_AD_IFINDEX;
  constexpr std::uint32_t kWhole = 0xffffffff;
  sock_filter steps[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kDevice), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, device, 1, 0),
                         BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, other, 0, 1), BPF_STMT(BPF_RET | BPF_K, kWhole),
                         BPF_STMT(BPF_RET | BPF_K, 0)};
  const sock_fprog program{std::size(steps), steps};
  if (::setsockopt(fd, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) != 0) {
    refuse("cannot be limited to an interface");
  }
}

void seal_descriptors(const std::set<int>& before, const NetworkInterface& interface) {
  for (const int fd : open_descriptors()) {
    if (before.contains(fd)) continue;
    const int flags = ::fcntl(fd, F_GETFD);
    if (flags < 0 || ::fcntl(fd, F_SETFD, flags | FD_CLOEXEC) != 0) refuse("cannot be closed on exec");
    if (!is_udp_socket(fd)) continue;
    if (!interface.loopback) {
      accept_from(fd, interface.index, find_interface("").index);
      continue;
    }
    const auto size = static_cast<socklen_t>(interface.device.size());
    if (::setsockopt(fd, SOL_SOCKET, SO_BINDTODEVICE, interface.device.c_str(), size) != 0) {
      refuse("cannot be bound to the device " + interface.device);
    }
  }
}

}  // namespace mrroc::links
