#include "links/reserved_domain.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::links {

ReservedDomain::ReservedDomain() : fd_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  if (fd_ < 0) throw SystemError(ErrorCode::resources, std::string("DDS domain: no socket: ") + std::strerror(errno));
  // an abstract address has one owner in the network namespace, as the domain's ports have, and ends with it
  constexpr int kLast = 99;  // above it the ports reach into the ephemeral range
  for (int id = 1; id <= kLast; ++id) {
    const std::string name = "mrroc/domain/" + std::to_string(id);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    if (::bind(fd_, reinterpret_cast<const sockaddr*>(&address), size) == 0) {
      id_ = id;
      return;
    }
  }
  ::close(fd_);
  throw SystemError(ErrorCode::resources, "DDS domain: the numbers 1 to 99 are all taken");
}

ReservedDomain::~ReservedDomain() { ::close(fd_); }

}  // namespace mrroc::links
