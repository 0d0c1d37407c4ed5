#include "cli/operator/socket/operator_socket.hpp"

#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/operator/socket/socket_folder.hpp"
#include "command/printable.hpp"

namespace mrroc::cli {

/// A connection.
struct OperatorSocket::Client {
  int fd = -1;
  OperatorClient identity;
  std::string incoming, outgoing;
  bool watching = false;
  WatchedStates states;
  bool listened_to = true;
  bool ended = false;       // it sends nothing more, but may still read
  std::size_t awaited = 0;  // replies that it has not been given yet
  bool finished = false;    // to be removed

  ~Client() { close(fd); }
};

namespace {

/// "mrroc (process 4711)": the peer, when it may be served.
std::string peer_of(int fd) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) return "";
  if (peer.uid != geteuid() && peer.uid != 0) return "";
  std::string program = "a process";
  std::ifstream("/proc/" + std::to_string(peer.pid) + "/comm") >> program;
  return command::printable(program) + " (process " + std::to_string(peer.pid) + ")";
}

/// Whether the peer has closed both directions.
bool hung_up(int fd) {
  pollfd state{fd, 0, 0};
  return ::poll(&state, 1, 0) > 0 && (state.revents & (POLLHUP | POLLERR)) != 0;
}

void watch(int epoll, int operation, int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  epoll_ctl(epoll, operation, fd, &event);
}

}  // namespace

OperatorSocket::OperatorSocket(OperatorService& service, const std::string& deployment)
    : service_(service), deployment_(deployment) {
  operator_sockets();  // removes those of runs that were killed: one may have the same process number
  path_ = make_socket_folder() / (deployment + "-" + std::to_string(getpid()) + ".sock");
  listener_ = listen_at(path_);
  wake_ = epoll_create1(EPOLL_CLOEXEC);
  if (wake_ < 0) throw std::runtime_error("the operator socket " + path_.string() + ": " + std::strerror(errno));
  watch(wake_, EPOLL_CTL_ADD, listener_);
}

OperatorSocket::~OperatorSocket() {
  for (auto& [number, client] : clients_) flush(*client);
  unlink(path_.c_str());
  close(listener_);
  clients_.clear();
  close(wake_);
}

bool OperatorSocket::watched() const noexcept {
  return std::any_of(clients_.begin(), clients_.end(), [](const auto& entry) { return entry.second->watching; });
}

void OperatorSocket::poll() {
  accept_clients();
  for (auto& [number, client] : clients_) serve(*client);
  for (auto entry = clients_.begin(); entry != clients_.end();) {
    const bool finished = entry->second->finished;
    if (finished) service_.leave(entry->second->identity);
    entry = finished ? clients_.erase(entry) : std::next(entry);
  }
}

void OperatorSocket::accept_clients() {
  for (int fd = 0; (fd = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK)) >= 0;) {
    auto client = std::make_unique<Client>();
    client->fd = fd;
    const std::string process = peer_of(fd);
    if (process.empty() || clients_.size() >= kMaxClients) continue;
    client->identity = {++accepted_, name_of(process)};
    watch(wake_, EPOLL_CTL_ADD, fd);
    write(*client, nlohmann::ordered_json{{"mrroc", kProtocol},
                                          {"version", MRROC_VERSION},
                                          {"deployment", deployment_},
                                          {"pid", getpid()},
                                          {"client", client->identity.name}}
                       .dump());
    clients_.emplace(accepted_, std::move(client));
  }
}

std::string OperatorSocket::name_of(const std::string& process) const {
  const auto same = [&process](const auto& entry) { return entry.second->identity.name.starts_with(process); };
  if (std::none_of(clients_.begin(), clients_.end(), same)) return process;
  return process + " #" + std::to_string(accepted_ + 1);
}

/// Reads no more than it executes in this turn: the rest stays in the socket, and its sender waits.
void OperatorSocket::serve(Client& client) {
  flush(client);
  std::size_t lines = 0;
  while (!client.finished && lines < kLinesPerTurn && client.outgoing.size() < kMaxWaiting / 2) {
    const std::size_t end = client.incoming.find('\n');
    if (end != std::string::npos) {
      const std::string line = client.incoming.substr(0, end);
      client.incoming.erase(0, end + 1);
      execute(client, line);
      ++lines;
      continue;
    }
    if (client.incoming.size() > kMaxLine) {
      VerbReply refusal;
      refusal.refusal = Refusal::malformed;
      refusal.text = "a line of more than " + std::to_string(kMaxLine) + " bytes";
      refusal.expected = "a shorter line; the connection is closed";
      write(client, to_json(refusal));
      client.finished = true;
      break;
    }
    char buffer[4096];
    const ssize_t size = recv(client.fd, buffer, sizeof buffer, 0);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    client.ended = size <= 0;
    if (client.ended) break;
    client.incoming.append(buffer, static_cast<std::size_t>(size));
  }
  if (client.ended && client.awaited == 0 && client.outgoing.empty() && !client.watching) client.finished = true;
  if (client.ended && hung_up(client.fd)) client.finished = true;
  listen_to(client, !client.ended && lines < kLinesPerTurn && client.outgoing.size() < kMaxWaiting / 2);
}

void OperatorSocket::execute(Client& client, const std::string& line) {
  VerbReply refusal;
  const std::optional<VerbRequest> request = parse_json(line, refusal);
  if (!request) {
    write(client, to_json(refusal));
    return;
  }
  const std::uint64_t number = client.identity.number;
  ++client.awaited;
  service_.request(client.identity, *request, [this, number](const VerbReply& reply) {
    const auto found = clients_.find(number);
    if (found == clients_.end()) return;
    --found->second->awaited;
    write(*found->second, to_json(reply));
  });
  if (request->verb->name != "echo") return;
  const auto states = watched_of(request->argument("of"));
  client.watching = client.watching || states.has_value();
  if (states) client.states = *states;
}

void OperatorSocket::publish(const std::string& json) {
  for (auto& [number, client] : clients_)
    if (client->watching) write(*client, json);
}

WatchedStates OperatorSocket::watched_states() const noexcept {
  WatchedStates all;
  for (const auto& [number, client] : clients_) {
    all.robots = all.robots || client->states.robots;
    all.readings = all.readings || client->states.readings;
    all.world = all.world || client->states.world;
  }
  return all;
}

void OperatorSocket::publish_state(const std::string& json, bool WatchedStates::*kind) {
  for (auto& [number, client] : clients_)
    if (client->states.*kind && client->outgoing.empty()) write(*client, json);
}

void OperatorSocket::write(Client& client, const std::string& line) {
  if (client.finished) return;
  client.outgoing += line;
  client.outgoing += '\n';
  flush(client);
  if (client.outgoing.size() > kMaxWaiting) client.finished = true;
}

void OperatorSocket::flush(Client& client) {
  while (!client.outgoing.empty()) {
    const ssize_t size = send(client.fd, client.outgoing.data(), client.outgoing.size(), MSG_NOSIGNAL);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (size <= 0) {
      client.finished = true;
      return;
    }
    client.outgoing.erase(0, static_cast<std::size_t>(size));
  }
}

void OperatorSocket::listen_to(Client& client, bool listen) {
  if (std::exchange(client.listened_to, listen) == listen) return;
  watch(wake_, listen ? EPOLL_CTL_ADD : EPOLL_CTL_DEL, client.fd);
}

}  // namespace mrroc::cli
