// An agent that only sends heartbeats, a thousand times a second. At the runner's `start` its clock jumps ahead by the
// milliseconds of its first argument.
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "cli/hosts/agent_protocol.hpp"
#include "cli/hosts/line_channel.hpp"
#include "clock/wall/monotonic.hpp"

using namespace mrroc;

namespace {

cli::AgentOrder take_order(cli::LineChannel& runner) {
  std::vector<std::string> lines;
  for (; !runner.closed(); poll(nullptr, 0, 1)) {
    for (const std::string& line : runner.read()) {
      if (line == "go") return cli::order_of_lines(lines);
      lines.push_back(line);
    }
  }
  std::exit(1);
}

/// A socket on any port of 127.0.0.1, connected to the runner's.
int open_socket(int runner) {
  const int fd = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  sockaddr_in peer{};
  peer.sin_family = AF_INET;
  peer.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  peer.sin_port = htons(static_cast<std::uint16_t>(runner));
  if (connect(fd, reinterpret_cast<const sockaddr*>(&peer), sizeof peer) != 0) std::exit(1);
  return fd;
}

int port_of(int fd) {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  getsockname(fd, reinterpret_cast<sockaddr*>(&own), &size);
  return ntohs(own.sin_port);
}

}  // namespace

int main(int, char** arguments) {
  const std::int64_t jump = 1'000'000 * std::strtoll(arguments[1], nullptr, 10);
  cli::LineChannel runner(STDIN_FILENO, STDOUT_FILENO);
  runner.write(std::string{cli::kAgentGreeting});
  const cli::AgentOrder order = take_order(runner);
  const int fd = open_socket(order.beat_port);
  runner.write("beat " + std::to_string(port_of(fd)));
  runner.write("missing");
  std::int64_t ahead = 0, heard_at = 0;
  cli::Heartbeat heard, own;
  for (; !runner.closed(); poll(nullptr, 0, 1)) {
    for (const std::string& line : runner.read())
      if (line.starts_with("start ")) ahead = jump;
    std::uint8_t datagram[256];
    for (ssize_t size = 0; (size = recv(fd, datagram, sizeof datagram, 0)) > 0;) {
      const auto beat = cli::open(datagram, static_cast<std::size_t>(size), order.key);
      if (!beat) continue;
      heard = *beat;
      heard_at = clock::monotonic_ns();
    }
    const std::int64_t now = clock::monotonic_ns();
    own = {false, own.sequence + 1, now + ahead, heard.sent, heard.sent == 0 ? 0 : now - heard_at};
    const auto sealed = cli::seal(own, order.key);
    if (send(fd, sealed.data(), sealed.size(), 0) < 0) continue;  // the runner is closing its end
  }
}
