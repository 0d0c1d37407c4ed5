#include "can/socket_bus.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "can/raw_frame.hpp"
#include "can/wait_readable.hpp"

namespace mrroc::can {

namespace {

[[noreturn]] void fail(const std::string& interface, const std::string& what) {
  throw std::runtime_error("CAN interface '" + interface + "': " + what);
}

void check_is_up(int socket, const std::string& interface) {
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  if (::ioctl(socket, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) == 0)
    fail(interface, "is down, expected it up: ip link set " + interface + " up type can bitrate 1000000");
}

/// Whether the interface is set up for CAN FD, and the socket for its frames.
bool turn_fd_on(int socket, const std::string& interface) {
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  if (::ioctl(socket, SIOCGIFMTU, &request) != 0 || request.ifr_mtu < static_cast<int>(CANFD_MTU)) return false;
  const int on = 1;
  return ::setsockopt(socket, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on) == 0;
}

}  // namespace

SocketBus::SocketBus(const std::string& interface) {
  const unsigned index = interface.size() < IFNAMSIZ ? ::if_nametoindex(interface.c_str()) : 0;
  socket_ = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
  if (socket_ < 0)
    fail(interface, errno == EAFNOSUPPORT ? "this kernel has no CAN, expected one with SocketCAN (modprobe can-raw)"
                                          : std::strerror(errno));
  try {
    if (index == 0)
      fail(interface, "is not there, expected the name of a CAN interface (ip -brief link show type can)");
    check_is_up(socket_, interface);
    const can_err_mask_t errors = CAN_ERR_MASK;
    ::setsockopt(socket_, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors);
    fd_ = turn_fd_on(socket_, interface);
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(index);
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      fail(interface, errno == ENODEV ? "is not a CAN interface" : std::strerror(errno));
  } catch (...) {
    ::close(socket_);
    throw;
  }
}

SocketBus::~SocketBus() { ::close(socket_); }

Sent SocketBus::send(const Frame& frame) noexcept {
  if (frame.fd && !fd_) return Sent::down;
  canfd_frame raw;
  const std::size_t size = to_raw(frame, raw);
  ssize_t sent = 0;
  do sent = ::send(socket_, &raw, size, MSG_DONTWAIT);
  while (sent < 0 && errno == EINTR);
  if (sent == static_cast<ssize_t>(size)) return Sent::yes;
  return errno == ENOBUFS || errno == EAGAIN || errno == ENOMEM ? Sent::full : Sent::down;
}

bool SocketBus::receive(Frame& frame, std::int64_t deadline) noexcept {
  for (;;) {
    canfd_frame raw{};
    const ssize_t size = ::recv(socket_, &raw, sizeof raw, MSG_DONTWAIT);
    if (size > 0) {
      if (from_raw(raw, static_cast<std::size_t>(size), frame)) return true;
      continue;
    }
    if (size < 0 && errno == EINTR) continue;
    // an interface that goes down causes one error, and `send` reports it; frames arrive again when it is up
    if (!wait_readable(socket_, deadline)) return false;
  }
}

void SocketBus::filter(std::span<const Filter> filters) {
  std::vector<can_filter> raw;
  for (const Filter& each : filters) raw.push_back({each.wanted, each.mask | CAN_EFF_FLAG});
  if (::setsockopt(socket_, SOL_CAN_RAW, CAN_RAW_FILTER, raw.data(),
                   static_cast<socklen_t>(raw.size() * sizeof(can_filter))) != 0)
    throw std::system_error(errno, std::generic_category(), "CAN_RAW_FILTER");
}

}  // namespace mrroc::can
