#include "sim/ur/tcp_listener.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace mrroc::sim::ur {
namespace {

[[noreturn]] void fail(const std::string& where) { throw std::system_error(errno, std::generic_category(), where); }

}  // namespace

std::pair<int, int> open_listener(const std::string& address, int port) {
  const std::string where = address + ":" + std::to_string(port);
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd < 0) fail(where);
  const int on = 1;
  ::setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::inet_pton(AF_INET, address.c_str(), &name.sin_addr) != 1) {
    ::close(fd);
    errno = EINVAL;
    fail(where);
  }
  socklen_t size = sizeof name;
  if (::bind(fd, reinterpret_cast<sockaddr*>(&name), size) != 0 || ::listen(fd, 16) != 0 ||
      ::getsockname(fd, reinterpret_cast<sockaddr*>(&name), &size) != 0) {
    const int reason = errno;
    ::close(fd);
    errno = reason;
    fail(where);
  }
  return {fd, ntohs(name.sin_port)};
}

}  // namespace mrroc::sim::ur
