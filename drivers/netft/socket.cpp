#include "drivers/netft/socket.hpp"

#include <netdb.h>

#include <memory>

#include "core/shown_text.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft {

sockaddr_in resolve(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* list = nullptr;
  const int error = ::getaddrinfo(host.c_str(), nullptr, &hints, &list);
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(list, &freeaddrinfo);
  if (error != 0 || list == nullptr || list->ai_addrlen < sizeof(sockaddr_in)) {
    throw HardwareError(ErrorCode::sensor_hardware, "'" + core::shown(host) + "': " + ::gai_strerror(error) +
                                                        ", expected the name or the IPv4 address of a Net F/T");
  }
  sockaddr_in address = *reinterpret_cast<const sockaddr_in*>(list->ai_addr);
  address.sin_port = htons(port);
  return address;
}

std::string place_text(const std::string& host, std::uint16_t port) {
  return core::shown(host).append(":").append(std::to_string(port));
}

}  // namespace mrroc::netft
