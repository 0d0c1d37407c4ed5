#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace mrroc::ur {

/// A connection that cannot be made, or has been lost. The text names the service, its address and port, and the
/// reason.
class ConnectionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A non-blocking TCP connection. Sends small packages at once (TCP_NODELAY).
class TcpSocket {
 public:
  TcpSocket() = default;
  /// Connects within `timeout` s. `service` is its name in errors. Throws ConnectionError.
  TcpSocket(const std::string& service, const std::string& address, int port, double timeout);
  ~TcpSocket();
  TcpSocket(TcpSocket&& other) noexcept;
  TcpSocket& operator=(TcpSocket&& other) noexcept;

  bool is_open() const noexcept { return fd_ >= 0; }
  int fd() const noexcept { return fd_; }
  void close() noexcept;
  /// The service with its address and port, for errors.
  const std::string& name() const noexcept { return name_; }

  /// Receives or sends what is possible now: the number of bytes, 0: nothing now, -1: the connection has ended.
  long receive(std::span<std::uint8_t> memory) noexcept;
  long send(std::span<const std::uint8_t> bytes) noexcept;

  /// Waits until bytes can be received; false: `deadline` (CLOCK_MONOTONIC, ns) came first.
  bool wait_readable(std::int64_t deadline) const noexcept;
  /// Sends all bytes; throws ConnectionError when they are not accepted by `deadline`.
  void send_all(std::span<const std::uint8_t> bytes, std::int64_t deadline);

 private:
  [[noreturn]] void fail(const std::string& reason) const;

  int fd_ = -1;
  std::string name_;
};

}  // namespace mrroc::ur
