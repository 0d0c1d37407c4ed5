#include "cli/panel/tls_door.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace mrroc::cli {

namespace {

constexpr int kTurn = 200;        // ms between looks at the end
constexpr int kHandShake = 5000;  // ms in which a client has to finish it
constexpr int kBacklog = 32;

std::string openssl_problem() {
  std::array<char, 256> text{};
  ERR_error_string_n(ERR_get_error(), text.data(), text.size());
  return text.data();
}

sockaddr_in address_of(const std::string& address, int port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1)
    throw std::runtime_error(address + " is not an IPv4 address");
  return place;
}

int connect_to_port(int port) {
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in place = address_of("127.0.0.1", port);
  if (fd < 0 || connect(fd, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) return fd;
  close(fd);
  return -1;
}

/// Bytes on their way in one direction.
struct Flow {
  std::array<char, 16384> bytes{};
  std::size_t begin = 0, end = 0;
  bool empty() const noexcept { return begin == end; }
};

using Session = std::unique_ptr<SSL, void (*)(SSL*)>;

/// Whether the session can continue after `result` of one of its calls.
bool goes_on(SSL* session, int result) {
  const int reason = SSL_get_error(session, result);
  return reason == SSL_ERROR_WANT_READ || reason == SSL_ERROR_WANT_WRITE;
}

}  // namespace

struct TlsDoor::Connection {
  std::thread thread;
  std::atomic<bool> finished{false};
  ~Connection() {
    if (thread.joinable()) thread.join();
  }
};

TlsDoor::TlsDoor(const std::string& address, int port, const std::filesystem::path& certificate, int inner)
    : context_(SSL_CTX_new(TLS_server_method()), SSL_CTX_free), inner_port_(inner) {
  if (context_ == nullptr) throw std::runtime_error("TLS: " + openssl_problem());
  SSL_CTX_set_min_proto_version(context_.get(), TLS1_2_VERSION);
  if (SSL_CTX_use_certificate_chain_file(context_.get(), certificate.c_str()) != 1 ||
      SSL_CTX_use_PrivateKey_file(context_.get(), certificate.c_str(), SSL_FILETYPE_PEM) != 1)
    throw std::runtime_error(certificate.string() + ": " + openssl_problem() +
                             ", expected a PEM file with a certificate and its private key");
  SSL_CTX_set_mode(context_.get(), SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  const sockaddr_in place = address_of(address, port);
  listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in bound{};
  socklen_t size = sizeof bound;
  if (listener_ < 0 || bind(listener_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
      listen(listener_, kBacklog) != 0 || getsockname(listener_, reinterpret_cast<sockaddr*>(&bound), &size) != 0) {
    const std::string reason = std::strerror(errno);
    if (listener_ >= 0) close(listener_);
    throw std::runtime_error("the panel cannot listen at " + address + ":" + std::to_string(port) + ": " + reason);
  }
  port_ = ntohs(bound.sin_port);
  acceptor_ = std::thread([this] { accept_connections(); });
}

TlsDoor::~TlsDoor() {
  ended_ = true;
  acceptor_.join();
  connections_.clear();
  close(listener_);
}

void TlsDoor::accept_connections() {
  while (!ended_) {
    pollfd entry{listener_, POLLIN, 0};
    ::poll(&entry, 1, kTurn);
    remove_finished();
    const int outer = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (outer < 0) continue;
    const int inner = connections_.size() < kMaxConnections ? connect_to_port(inner_port_) : -1;
    if (inner < 0) {
      close(outer);
      continue;
    }
    Connection& connection = *connections_.emplace_back(std::make_unique<Connection>());
    connection.thread = std::thread([this, outer, inner, &connection] {
      pass_on(outer, inner);
      close(outer);
      close(inner);
      connection.finished = true;
    });
  }
}

void TlsDoor::remove_finished() {
  connections_.remove_if([](const auto& connection) { return connection->finished.load(); });
}

/// Both directions by turns, each only while there is room: a client that does not read stops its own server alone.
void TlsDoor::pass_on(int outer, int inner) const {
  const int on = 1;
  setsockopt(outer, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  setsockopt(inner, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  fcntl(inner, F_SETFL, O_NONBLOCK);
  const Session session(SSL_new(context_.get()), SSL_free);
  if (session == nullptr || SSL_set_fd(session.get(), outer) != 1) return;
  for (int idle = 0;;) {
    const int result = SSL_accept(session.get());
    if (result == 1) break;
    if (!goes_on(session.get(), result) || idle > kHandShake / kTurn || ended_) return;
    pollfd entry{outer, static_cast<short>(SSL_want_write(session.get()) ? POLLOUT : POLLIN), 0};
    if (::poll(&entry, 1, kTurn) == 0) ++idle;
  }
  Flow in, out;
  while (!ended_) {
    if (in.empty()) {
      const int size = SSL_read(session.get(), in.bytes.data(), static_cast<int>(in.bytes.size()));
      if (size <= 0 && !goes_on(session.get(), size)) return;
      in.begin = 0;
      in.end = size > 0 ? static_cast<std::size_t>(size) : 0;
    }
    if (!in.empty()) {
      const ssize_t size = send(inner, in.bytes.data() + in.begin, in.end - in.begin, MSG_NOSIGNAL);
      if (size < 0 && errno != EAGAIN && errno != EINTR) return;
      if (size > 0) in.begin += static_cast<std::size_t>(size);
    }
    if (out.empty()) {
      const ssize_t size = recv(inner, out.bytes.data(), out.bytes.size(), 0);
      if (size == 0) return;
      if (size < 0 && errno != EAGAIN && errno != EINTR) return;
      out.begin = 0;
      out.end = size > 0 ? static_cast<std::size_t>(size) : 0;
    }
    if (!out.empty()) {
      const int size = SSL_write(session.get(), out.bytes.data() + out.begin, static_cast<int>(out.end - out.begin));
      if (size <= 0 && !goes_on(session.get(), size)) return;
      if (size > 0) out.begin += static_cast<std::size_t>(size);
    }
    if (SSL_pending(session.get()) > 0 && in.empty()) continue;
    pollfd entries[2]{{outer, static_cast<short>((in.empty() ? POLLIN : 0) | (out.empty() ? 0 : POLLOUT)), 0},
                      {inner, static_cast<short>((out.empty() ? POLLIN : 0) | (in.empty() ? 0 : POLLOUT)), 0}};
    ::poll(entries, 2, kTurn);
  }
}

}  // namespace mrroc::cli
