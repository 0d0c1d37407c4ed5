#include "drivers/ur/tcp_socket.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

#include "clock/wall/wait.hpp"

namespace mrroc::ur {
namespace {

struct FreeList {
  void operator()(addrinfo* list) const noexcept { freeaddrinfo(list); }
};

}  // namespace

TcpSocket::TcpSocket(const std::string& service, const std::string& address, int port, double timeout)
    : name_(service + " at " + address + ":" + std::to_string(port)) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  if (const int code = getaddrinfo(address.c_str(), std::to_string(port).c_str(), &hints, &list); code != 0)
    fail(gai_strerror(code));
  const std::unique_ptr<addrinfo, FreeList> addresses(list);
  const std::int64_t deadline = clock::monotonic_ns() + std::llround(timeout * 1e9);
  int reason = 0;
  for (const addrinfo* entry = list; entry != nullptr; entry = entry->ai_next) {
    fd_ = ::socket(entry->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd_ < 0) fail(std::strerror(errno));
    reason = ::connect(fd_, entry->ai_addr, entry->ai_addrlen) == 0 ? 0 : errno;
    if (reason == EINPROGRESS) {
      socklen_t size = sizeof reason;
      if (!clock::wait_for(fd_, POLLOUT, deadline))
        reason = ETIMEDOUT;
      else
        ::getsockopt(fd_, SOL_SOCKET, SO_ERROR, &reason, &size);
    }
    if (reason == 0) break;
    close();
  }
  if (reason == ETIMEDOUT) fail("no answer to the connection within " + std::to_string(timeout) + " s");
  if (reason != 0) fail(std::strerror(reason));
  const int on = 1;
  ::setsockopt(fd_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

TcpSocket::~TcpSocket() { close(); }

TcpSocket::TcpSocket(TcpSocket&& other) noexcept : fd_(std::exchange(other.fd_, -1)), name_(std::move(other.name_)) {}

TcpSocket& TcpSocket::operator=(TcpSocket&& other) noexcept {
  if (this == &other) return *this;
  close();
  fd_ = std::exchange(other.fd_, -1);
  name_ = std::move(other.name_);
  return *this;
}

void TcpSocket::close() noexcept {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

long TcpSocket::receive(std::span<std::uint8_t> memory) noexcept {
  const ssize_t size = ::recv(fd_, memory.data(), memory.size(), 0);
  if (size > 0) return size;
  return size < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

long TcpSocket::send(std::span<const std::uint8_t> bytes) noexcept {
  const ssize_t size = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (size >= 0) return size;
  return errno == EAGAIN || errno == EINTR ? 0 : -1;
}

bool TcpSocket::wait_readable(std::int64_t deadline) const noexcept { return clock::wait_for(fd_, POLLIN, deadline); }

void TcpSocket::send_all(std::span<const std::uint8_t> bytes, std::int64_t deadline) {
  while (!bytes.empty()) {
    const long size = send(bytes);
    if (size < 0) fail("the connection has ended");
    bytes = bytes.subspan(static_cast<std::size_t>(size));
    if (!bytes.empty() && !clock::wait_for(fd_, POLLOUT, deadline)) fail("it does not take our data");
  }
}

void TcpSocket::fail(const std::string& reason) const { throw ConnectionError(name_ + ": " + reason); }

}  // namespace mrroc::ur
