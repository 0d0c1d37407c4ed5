// The configuration page of the simulated Net F/T, over HTTP.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "clock/wall/monotonic.hpp"
#include "config/text/message_text.hpp"
#include "drivers/netft/calibration.hpp"
#include "sim/netft/netft_server.hpp"

namespace mrroc::sim {

namespace {

constexpr std::size_t kMaxRequest = 4096;
constexpr std::int64_t kConnectionLife = 5 * clock::kSecond;

/// Whole numbers without an exponent: some clients read them as integers.
std::string count_text(double counts) {
  return counts == std::floor(counts) && counts < 1e15 ? std::to_string(std::llround(counts))
                                                       : config::number_text(counts);
}

std::string answer_of(const std::string& status, const std::string& type, const std::string& body) {
  return "HTTP/1.0 " + status + "\r\nContent-Type: " + type + "\r\nContent-Length: " + std::to_string(body.size()) +
         "\r\nConnection: close\r\n\r\n" + body;
}

}  // namespace

void NetftServer::serve_http() {
  const std::int64_t now = clock::monotonic_ns();
  for (;;) {
    netft::Descriptor socket(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!socket.valid()) break;
    if (connections_.size() == kMaxConnections) connections_.erase(connections_.begin());
    connections_.push_back({std::move(socket), "", now + kConnectionLife});
  }
  std::erase_if(connections_, [&](Connection& each) { return answer(each, now); });
}

/// Reads what has come of a request and answers a whole one; true: the connection ends.
bool NetftServer::answer(Connection& connection, std::int64_t now) {
  std::array<char, 1024> part{};
  for (;;) {
    const ssize_t size = ::recv(connection.socket.get(), part.data(), part.size(), 0);
    if (size == 0) return true;
    if (size < 0) break;
    connection.request.append(part.data(), static_cast<std::size_t>(size));
    if (connection.request.size() > kMaxRequest) return true;
  }
  if (connection.request.find("\r\n\r\n") == std::string::npos) return now > connection.deadline;
  const std::string& request = connection.request;
  std::string given = answer_of("404 Not Found", "text/plain", "not found\n");
  for (const char* end : {" ", "?"}) {
    if (request.starts_with(std::string("GET ") + netft::kConfigurationPath + end)) {
      given = answer_of("200 OK", "text/xml", page());
    }
  }
  // a page is smaller than the buffer of a new connection
  static_cast<void>(::send(connection.socket.get(), given.data(), given.size(), MSG_NOSIGNAL));
  ::shutdown(connection.socket.get(), SHUT_WR);
  return true;
}

std::string NetftServer::page() const {
  if (!settings_.page.empty()) return settings_.page;
  std::array<char, 16> status{};
  std::snprintf(status.data(), status.size(), "0x%08x", static_cast<unsigned>(newest_.status));
  std::string made = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<netFTApi>\n";
  const auto element = [&made](const char* name, const std::string& value) {
    made.append("<").append(name).append(">").append(value).append("</").append(name).append(">\n");
  };
  element("runstat", status.data());
  element("cfgnam", "Simulated");
  element("cfgcpf", count_text(settings_.counts_per_force));
  element("cfgcpt", count_text(settings_.counts_per_torque));
  element("scfgfu", settings_.force_unit);
  element("scfgtu", settings_.torque_unit);
  element("comrdte", "Enabled");
  element("comrdtrate", count_text(settings_.rate));
  element("comrdtbsiz", std::to_string(settings_.buffer));
  element("prodname", "Simulated Net F/T");
  return made + "</netFTApi>\n";
}

}  // namespace mrroc::sim
