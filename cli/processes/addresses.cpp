#include "cli/processes/addresses.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace mrroc::cli {

in_addr ipv4_of(const std::string& host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* list = nullptr;
  if (const int code = getaddrinfo(host.c_str(), nullptr, &hints, &list); code != 0)
    throw std::runtime_error("address '" + host + "': " + gai_strerror(code));
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(list, &freeaddrinfo);
  return reinterpret_cast<const sockaddr_in*>(list->ai_addr)->sin_addr;
}

in_addr own_address_towards(in_addr peer) {
  const auto refuse = [peer] {
    return std::runtime_error("no route to " + to_text(peer) + ": " + std::strerror(errno));
  };
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (probe < 0) throw refuse();
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr = peer;
  address.sin_port = htons(7400);
  socklen_t size = sizeof address;
  const bool routed = connect(probe, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                      getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  close(probe);
  if (!routed) throw refuse();
  return address.sin_addr;
}

std::string to_text(in_addr address) {
  char text[INET_ADDRSTRLEN] = "";
  inet_ntop(AF_INET, &address, text, sizeof text);
  return text;
}

}  // namespace mrroc::cli
