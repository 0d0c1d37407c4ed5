#include "can/hub_bus.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "can/hub_address.hpp"
#include "can/raw_frame.hpp"
#include "can/wait_readable.hpp"

namespace mrroc::can {

HubBus::HubBus(const std::string& path) {
  const sockaddr_un address = hub_address(path);
  socket_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0 || ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const std::string why = std::strerror(errno);
    if (socket_ >= 0) ::close(socket_);
    throw std::runtime_error("CAN hub '" + path + "': " + why + ", expected the socket of a running hub");
  }
}

HubBus::~HubBus() { ::close(socket_); }

Sent HubBus::send(const Frame& frame) noexcept {
  canfd_frame raw;
  const std::size_t size = to_raw(frame, raw);
  ssize_t sent = 0;
  do sent = ::send(socket_, &raw, size, MSG_DONTWAIT | MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  if (sent == static_cast<ssize_t>(size)) return Sent::yes;
  return errno == EAGAIN || errno == ENOBUFS ? Sent::full : Sent::down;
}

bool HubBus::receive(Frame& frame, std::int64_t deadline) noexcept {
  for (;;) {
    canfd_frame raw{};
    const ssize_t size = ::recv(socket_, &raw, sizeof raw, MSG_DONTWAIT);
    if (size == 0) return false;  // the hub has ended
    if (size > 0) {
      if (from_raw(raw, static_cast<std::size_t>(size), frame) && wanted(frame)) return true;
      continue;
    }
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && errno != EAGAIN) return false;
    if (!wait_readable(socket_, deadline)) return false;
  }
}

bool HubBus::wanted(const Frame& frame) const noexcept {
  return frame.error || std::any_of(filters_.begin(), filters_.end(), [&frame](const Filter& filter) {
           return ((frame.id ^ filter.wanted) & filter.mask) == 0;
         });
}

}  // namespace mrroc::can
