#pragma once

#include <openssl/types.h>

#include <atomic>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace mrroc::cli {

/// TLS in front of a server of this machine that speaks without: each connection to the door is decrypted and passed on
/// to a port of loopback. Debian's civetweb 1.15 calls a function that OpenSSL 3 no longer has, and ends with the first
/// request by TLS. One thread accepts, one for each connection passes on.
class TlsDoor {
 public:
  static constexpr std::size_t kMaxConnections = 48;

  /// Listens at `address` and `port` (0: any free one). `certificate`: PEM file with certificate and private key;
  /// `inner`: port of loopback to which connections are passed on. Throws std::runtime_error with the reason.
  TlsDoor(const std::string& address, int port, const std::filesystem::path& certificate, int inner);
  ~TlsDoor();
  TlsDoor(const TlsDoor&) = delete;
  TlsDoor& operator=(const TlsDoor&) = delete;

  int port() const noexcept { return port_; }

 private:
  struct Connection;

  void accept_connections();
  void remove_finished();
  void pass_on(int outer, int inner) const;

  std::unique_ptr<SSL_CTX, void (*)(SSL_CTX*)> context_;
  int inner_port_;
  int listener_ = -1;
  int port_ = 0;
  std::atomic<bool> ended_{false};
  std::list<std::unique_ptr<Connection>> connections_;
  std::thread acceptor_;
};

}  // namespace mrroc::cli
