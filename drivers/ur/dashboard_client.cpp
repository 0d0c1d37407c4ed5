#include "drivers/ur/dashboard_client.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "clock/wall/monotonic.hpp"

namespace mrroc::ur {
namespace {

constexpr std::size_t kLongestLine = 4096;

std::int64_t deadline_of(double timeout) { return clock::monotonic_ns() + std::llround(timeout * 1e9); }

bool starts_alike(std::string_view text, std::string_view start) {
  constexpr auto kLower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return text.size() >= start.size() &&
         std::equal(start.begin(), start.end(), text.begin(), [&](char a, char b) { return kLower(a) == kLower(b); });
}

}  // namespace

DashboardClient::DashboardClient(const std::string& address, int port, double timeout)
    : socket_("the dashboard server", address, port, timeout), timeout_(timeout) {
  take_line();
}

std::string DashboardClient::ask(std::string_view command) {
  const std::string line = std::string(command) + "\n";
  socket_.send_all({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, deadline_of(timeout_));
  return answer_ = take_line();
}

bool DashboardClient::accepts(std::string_view command, std::string_view expected) {
  return starts_alike(ask(command), expected);
}

bool DashboardClient::is_in_remote_control() {
  ask("is in remote control");
  return !starts_alike(answer_, "false");
}

std::string DashboardClient::after_colon(const std::string& line) {
  const std::size_t colon = line.find(": ");
  return colon == std::string::npos ? line : line.substr(colon + 2);
}

std::string DashboardClient::take_line() {
  const std::int64_t deadline = deadline_of(timeout_);
  for (;;) {
    if (const std::size_t end = received_.find('\n'); end != std::string::npos) {
      std::string line = received_.substr(0, end);
      received_.erase(0, end + 1);
      if (line.ends_with('\r')) line.pop_back();
      return line;
    }
    if (received_.size() > kLongestLine) throw ConnectionError(socket_.name() + ": a line without end");
    std::array<std::uint8_t, 512> bytes{};
    if (!socket_.wait_readable(deadline)) throw ConnectionError(socket_.name() + ": no answer");
    const long size = socket_.receive(bytes);
    if (size < 0) throw ConnectionError(socket_.name() + ": the controller has closed the connection");
    received_.append(reinterpret_cast<const char*>(bytes.data()), static_cast<std::size_t>(size));
  }
}

}  // namespace mrroc::ur
