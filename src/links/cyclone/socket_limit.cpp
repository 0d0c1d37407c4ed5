#include "links/cyclone/socket_limit.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/sockets.h>
#include <linux/filter.h>
#include <sys/socket.h>

#include <cstdint>
#include <iterator>

#include "links/cyclone/cyclone_function.hpp"

namespace mrroc::links {
namespace {

using Bind = decltype(&ddsrt_bind);

Bind cyclone_bind() noexcept {
  static const auto function = cyclone_function<Bind>("ddsrt_bind");
  return function;
}

/// The kernel's number of the loopback device in every network namespace (LOOPBACK_IFINDEX of its sources).
constexpr unsigned kLoopbackDevice = 1;

/// 0: Cyclone's sockets are not limited.
thread_local unsigned limit_device = 0;
thread_local unsigned limit_other = 0;

}  // namespace

SocketLimit::SocketLimit(const NetworkInterface& interface) noexcept {
  cyclone_bind();
  limit_device = interface.index;
  limit_other = kLoopbackDevice;
}

SocketLimit::~SocketLimit() { limit_device = limit_other = 0; }

bool accept_from(int fd, unsigned device, unsigned other) noexcept {
  constexpr std::uint32_t kDevice = static_cast<std::uint32_t>(SKF_AD_OFF) + SKF_AD_IFINDEX;
  constexpr std::uint32_t kWhole = 0xffffffff;
  sock_filter steps[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kDevice), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, device, 1, 0),
                         BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, other, 0, 1), BPF_STMT(BPF_RET | BPF_K, kWhole),
                         BPF_STMT(BPF_RET | BPF_K, 0)};
  const sock_fprog program{std::size(steps), steps};
  return ::setsockopt(fd, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

bool is_limited(int fd) noexcept {
  socklen_t steps = 0;
  return ::getsockopt(fd, SOL_SOCKET, SO_GET_FILTER, nullptr, &steps) == 0 && steps > 0;
}

}  // namespace mrroc::links

// instead of Cyclone's own, which it finds here first
extern "C" dds_return_t ddsrt_bind(ddsrt_socket_t socket, const sockaddr* address, socklen_t size) {
  using namespace mrroc::links;
  if (limit_device != 0 && !accept_from(socket, limit_device, limit_other)) return DDS_RETCODE_ERROR;
  return cyclone_bind()(socket, address, size);
}
