#pragma once

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace mrroc::netft {

/// An open file descriptor, closed at the end of its scope; -1: no file.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) noexcept : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }

  int get() const noexcept { return fd_; }
  bool valid() const noexcept { return fd_ >= 0; }

 private:
  int fd_;
};

inline const sockaddr* generic(const sockaddr_in& address) noexcept {
  return reinterpret_cast<const sockaddr*>(&address);
}
inline sockaddr* generic(sockaddr_in& address) noexcept { return reinterpret_cast<sockaddr*>(&address); }

/// The IPv4 address of `host`, a name or a number. Waits for the name server where it is a name. Throws
/// HardwareError(sensor_hardware) when the name has no address.
sockaddr_in resolve(const std::string& host, std::uint16_t port);

/// "host:port", for messages.
std::string place_text(const std::string& host, std::uint16_t port);

/// A time in s as nanoseconds.
inline std::int64_t to_ns(double seconds) noexcept { return std::llround(seconds * 1e9); }

}  // namespace mrroc::netft
