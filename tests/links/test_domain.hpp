#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "links/transport/domain.hpp"

namespace mrroc::links {

/// A DDS domain number that no other process of this machine uses meanwhile, locked like the runner's domains.
class FreeDomain {
 public:
  FreeDomain() : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    for (id_ = 1; id_ <= 100; ++id_) {
      sockaddr_un address{};
      address.sun_family = AF_UNIX;
      const int length = std::snprintf(address.sun_path + 1, sizeof address.sun_path - 1, "mrroc-domain-%d", id_);
      const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + static_cast<std::size_t>(length));
      if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) == 0) return;
    }
    throw std::runtime_error("no free DDS domain");
  }
  ~FreeDomain() { ::close(socket_); }
  FreeDomain(const FreeDomain&) = delete;
  FreeDomain& operator=(const FreeDomain&) = delete;

  int id() const noexcept { return id_; }

 private:
  int socket_;
  int id_ = 0;
};

/// Long, so that a busy machine does not cause a failure.
inline constexpr double kPatience = 30;

/// Checks `condition` every millisecond until it holds; false when it does not hold within half a minute.
template <class Condition>
bool eventually(Condition condition) {
  for (int i = 0; i < kPatience * 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// A participant of a free domain. Its lease outlasts any stall of a busy machine.
struct TestDomain {
  explicit TestDomain(double lease = 20) : domain({.id = number.id(), .lease = lease}) {}
  FreeDomain number;
  Domain domain;
};

}  // namespace mrroc::links
