#include "can/hub.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "can/hub_address.hpp"
#include "can/raw_frame.hpp"

namespace mrroc::can {

Hub::Hub(std::filesystem::path path, Fault fault) : path_(std::move(path)), fault_(std::move(fault)) {
  const sockaddr_un address = hub_address(path_.string());
  listener_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  stop_ = ::eventfd(0, EFD_CLOEXEC);
  // before `bind`, which gives the file the socket's permissions: whoever may write to it commands drives
  if (listener_ < 0 || stop_ < 0 || ::fchmod(listener_, S_IRUSR | S_IWUSR) != 0 ||
      ::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(listener_, 16) != 0) {
    const std::string why = std::strerror(errno);
    if (listener_ >= 0) ::close(listener_);
    if (stop_ >= 0) ::close(stop_);
    throw std::runtime_error("CAN hub '" + path_.string() + "': " + why + ", expected a path where none is yet");
  }
  thread_ = std::thread([this] { serve(); });
}

Hub::~Hub() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t told = ::write(stop_, &one, sizeof one);
  thread_.join();
  for (const int client : clients_) ::close(client);
  ::close(listener_);
  ::close(stop_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void Hub::serve() {
  for (;;) {
    std::vector<pollfd> entries{{stop_, POLLIN, 0}, {listener_, POLLIN, 0}};
    for (const int client : clients_) entries.push_back({client, POLLIN, 0});
    if (::poll(entries.data(), entries.size(), -1) < 0) continue;
    if (entries[0].revents != 0) return;
    accept();  // first: who has connected before a frame was sent gets it
    for (std::size_t i = 2; i < entries.size(); ++i) {
      if (entries[i].revents == 0 || relay(entries[i].fd)) continue;
      ::close(entries[i].fd);
      std::erase(clients_, entries[i].fd);
    }
  }
}

void Hub::accept() {
  for (;;) {
    const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (client < 0) return;
    clients_.push_back(client);
  }
}

/// Hands one frame on; false: its sender has gone.
bool Hub::relay(int from) {
  canfd_frame raw{};
  const ssize_t size = ::recv(from, &raw, sizeof raw, MSG_DONTWAIT);
  if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) return false;
  Frame frame;
  if (size < 0 || !from_raw(raw, static_cast<std::size_t>(size), frame)) return true;
  if (fault_ && !fault_(frame)) return true;
  const std::size_t length = to_raw(frame, raw);
  frames_.fetch_add(1, std::memory_order_relaxed);
  for (const int client : clients_)
    if (client != from) ::send(client, &raw, length, MSG_DONTWAIT | MSG_NOSIGNAL);
  return true;
}

}  // namespace mrroc::can
