#include "can/hub.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "can/raw_frame.hpp"

namespace mrroc::can {

Hub::Hub(std::filesystem::path path, Disturbance disturbance)
    : disturbance_(std::move(disturbance)), listener_(std::move(path)), stop_(::eventfd(0, EFD_CLOEXEC)) {
  if (stop_ < 0) throw std::runtime_error("CAN hub '" + listener_.path().string() + "': " + std::strerror(errno));
  thread_ = std::thread([this] { serve(); });
}

Hub::~Hub() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t reported = ::write(stop_, &one, sizeof one);
  thread_.join();
  for (const int client : clients_) ::close(client);
  ::close(stop_);
}

void Hub::serve() {
  for (;;) {
    std::vector<pollfd> entries{{stop_, POLLIN, 0}, {listener_.fd(), POLLIN, 0}};
    for (const int client : clients_) entries.push_back({client, POLLIN, 0});
    if (::poll(entries.data(), entries.size(), -1) < 0) continue;
    if (entries[0].revents != 0) return;
    accept();  // first, so that clients that have connected before a frame was sent get it
    for (std::size_t i = 2; i < entries.size(); ++i) {
      if (entries[i].revents == 0 || relay(entries[i].fd)) continue;
      ::close(entries[i].fd);
      std::erase(clients_, entries[i].fd);
    }
  }
}

void Hub::accept() {
  for (;;) {
    const int client = ::accept4(listener_.fd(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (client < 0) return;
    clients_.push_back(client);
  }
}

/// Forwards one frame; false: its sender has disconnected.
bool Hub::relay(int from) {
  canfd_frame raw{};
  const ssize_t size = ::recv(from, &raw, sizeof raw, MSG_DONTWAIT);
  // a client that leaves with unread frames is reported as a reset before its last frames
  const bool goes_on = size > 0 || (size < 0 && (errno == EAGAIN || errno == EINTR || errno == ECONNRESET));
  if (!goes_on) return false;
  Frame frame;
  if (size < 0 || !from_raw(raw, static_cast<std::size_t>(size), frame)) return true;
  if (disturbance_ && !disturbance_(frame)) return true;
  const std::size_t length = to_raw(frame, raw);
  frames_.fetch_add(1, std::memory_order_relaxed);
  for (const int client : clients_)
    if (client != from) ::send(client, &raw, length, MSG_DONTWAIT | MSG_NOSIGNAL);
  return true;
}

}  // namespace mrroc::can
