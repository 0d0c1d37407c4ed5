#include "drivers/netft/http_get.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>

#include "clock/wall/wait.hpp"
#include "config/text/message_text.hpp"
#include "core/number_text.hpp"
#include "drivers/netft/socket.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft {

namespace {

[[noreturn]] void fail(const std::string& place, const std::string& problem, const std::string& expected) {
  throw HardwareError(ErrorCode::sensor_hardware, place + ": " + problem + ", expected " + expected);
}

/// One exchange with a server, until the deadline.
class Exchange {
 public:
  Exchange(const std::string& host, std::uint16_t port, double timeout)
      : place_("http://" + place_text(host, port)),
        timeout_(timeout),
        deadline_(clock::monotonic_ns() + to_ns(timeout)),
        socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    if (!socket_.valid()) fail_by_system("no socket");
    const sockaddr_in address = resolve(host, port);
    if (::connect(socket_.get(), generic(address), sizeof address) == 0) return;
    if (errno != EINPROGRESS) fail_by_system("no connection");
    wait(POLLOUT);
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
    errno = error;
    if (error != 0) fail_by_system("no connection");
  }

  const std::string& place() const noexcept { return place_; }

  void send(std::string_view text) {
    while (!text.empty()) {
      wait(POLLOUT);
      const ssize_t sent = ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno != EAGAIN && errno != EINTR) fail_by_system("the request was not sent");
      if (sent > 0) text.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

  /// Until the server closes the connection.
  std::string receive() {
    std::string answer;
    std::array<char, 4096> part{};
    for (;;) {
      wait(POLLIN);
      const ssize_t size = ::recv(socket_.get(), part.data(), part.size(), 0);
      if (size == 0) return answer;
      if (size < 0 && errno != EAGAIN && errno != EINTR) fail_by_system("the answer is incomplete");
      if (size > 0) answer.append(part.data(), static_cast<std::size_t>(size));
      if (answer.size() > kMaxAnswer) {
        fail(place_, "an answer of more than " + std::to_string(kMaxAnswer) + " bytes",
             "the configuration page of a Net F/T");
      }
    }
  }

 private:
  void wait(short events) {
    if (clock::wait_for(socket_.get(), events, deadline_)) return;
    fail(place_, "no complete answer within " + config::number_text(timeout_) + " s",
         "the configuration page of a Net F/T");
  }
  [[noreturn]] void fail_by_system(const std::string& problem) const {
    const std::string why = std::strerror(errno);
    fail(place_, problem + ": " + why, "the configuration page of a Net F/T");
  }

  std::string place_;
  double timeout_;
  std::int64_t deadline_;
  Descriptor socket_;
};

std::string lower(std::string_view text) {
  std::string made(text);
  std::transform(made.begin(), made.end(), made.begin(), [](unsigned char each) { return std::tolower(each); });
  return made;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// The field `name` (in lower case) of the header lines; nothing: they have no such field.
std::optional<std::string> field(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = header.find("\r\n");
    const std::string_view line = header.substr(0, end);
    header.remove_prefix(end == std::string_view::npos ? header.size() : end + 2);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || lower(line.substr(0, colon)) != name) continue;
    return std::string(trimmed(line.substr(colon + 1)));
  }
  return {};
}

}  // namespace

std::string body_of(const std::string& answer, const std::string& place) {
  const std::size_t end = answer.find("\r\n\r\n");
  if (end == std::string::npos || !answer.starts_with("HTTP/1.")) {
    fail(place, "not an answer of HTTP: " + config::in_quotes(answer), "the configuration page of a Net F/T");
  }
  const std::string_view head = std::string_view(answer).substr(0, end);
  const std::string_view first = head.substr(0, head.find("\r\n"));
  const std::size_t blank = first.find(' ');
  const std::string_view status = blank == std::string_view::npos ? "" : trimmed(first.substr(blank));
  if (!status.starts_with("200")) fail(place, "status " + config::in_quotes(status), "200");
  for (const char* encoding : {"transfer-encoding", "content-encoding"}) {
    const auto value = field(head, encoding);
    if (value && lower(*value) != "identity") {
      fail(place, std::string(encoding) + " " + config::in_quotes(*value), "a page without an encoding");
    }
  }
  std::string body = answer.substr(end + 4);
  if (const auto given = field(head, "content-length")) {
    const auto length = core::to_whole<std::uint64_t>(*given);
    if (!length || *length > body.size()) {
      fail(place, std::to_string(body.size()) + " bytes", "a page of " + config::in_quotes(*given));
    }
    body.resize(*length);
  }
  return body;
}

std::string http_get(const std::string& host, std::uint16_t port, const std::string& path, double timeout) {
  Exchange exchange(host, port, timeout);
  exchange.send("GET " + path + " HTTP/1.0\r\nHost: " + host + "\r\nConnection: close\r\n\r\n");
  return body_of(exchange.receive(), exchange.place() + path);
}

}  // namespace mrroc::netft
