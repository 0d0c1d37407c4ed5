#include "cli/operator/socket/run_connection.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cli/operator/operator_verbs.hpp"
#include "cli/operator/socket/operator_socket.hpp"
#include "cli/operator/socket/socket_folder.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr double kGreetingTimeout = 5;  // s
constexpr double kReplyTimeout = 10;    // s
constexpr int kSilence = 2000;          // ms

bool is_of(const std::filesystem::path& socket, const std::string& deployment) {
  const std::string name = socket.stem().string();
  return deployment.empty() || name == deployment || name.substr(0, name.rfind('-')) == deployment;
}

std::string names_of(const std::vector<std::filesystem::path>& sockets) {
  std::string names;
  for (const std::filesystem::path& socket : sockets) names += (names.empty() ? "" : ", ") + socket.stem().string();
  return names;
}

}  // namespace

RunConnection RunConnection::to(const std::string& deployment) {
  const std::vector<std::filesystem::path> all = operator_sockets();
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& socket : all)
    if (is_of(socket, deployment)) found.push_back(socket);
  if (found.size() == 1) return RunConnection(found.front());
  if (found.size() > 1) throw std::runtime_error("more than one run matches, expected one of " + names_of(found));
  if (all.empty())
    throw std::runtime_error("no deployment of this user runs on this machine, expected 'mrroc run' before");
  throw std::runtime_error("no run of '" + deployment + "' on this machine, expected one of " + names_of(all));
}

RunConnection::RunConnection(const std::filesystem::path& socket) : path_(socket), fd_(connect_to(socket)) {
  if (fd_ < 0) throw std::runtime_error(path_.string() + ": " + std::strerror(errno));
  const std::optional<std::string> line = next_line(kGreetingTimeout);
  const auto greeting = nlohmann::json::parse(line.value_or(""), nullptr, false);
  if (!greeting.is_object() || greeting.value("mrroc", 0) != OperatorSocket::kProtocol)
    throw std::runtime_error(path_.string() + ": the run has another version of MRROC++, expected protocol " +
                             std::to_string(OperatorSocket::kProtocol));
  deployment_ = greeting.value("deployment", "");
  pid_ = greeting.value("pid", 0);
  client_ = greeting.value("client", "");
}

RunConnection::~RunConnection() {
  if (fd_ >= 0) close(fd_);
}

RunConnection::RunConnection(RunConnection&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      deployment_(std::move(other.deployment_)),
      pid_(other.pid_),
      client_(std::move(other.client_)),
      incoming_(std::move(other.incoming_)) {}

VerbReply RunConnection::request(std::string_view verb, const std::map<std::string, std::string>& arguments,
                                 const std::function<void()>& slow) {
  nlohmann::json json(arguments);
  if (!json.is_object()) json = nlohmann::json::object();
  json["verb"] = verb;
  if (!send_line(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)))
    throw std::runtime_error(deployment_ + ": the connection to the run is lost");
  const OperatorVerb* const known = find_verb(verb);
  if (pollfd entry{fd_, POLLIN, 0}; slow && poll(&entry, 1, kSilence) == 0) slow();
  for (;;) {
    const std::optional<std::string> answer = next_line(known != nullptr && known->lasts ? -1 : kReplyTimeout);
    if (!answer) throw std::runtime_error(deployment_ + ": the run has ended");
    if (const std::optional<VerbReply> reply = parse_reply(*answer)) return *reply;
  }
}

bool RunConnection::send_line(const std::string& line) {
  const std::string whole = line + "\n";
  for (std::size_t sent = 0; sent < whole.size();) {
    const ssize_t size = send(fd_, whole.data() + sent, whole.size() - sent, MSG_NOSIGNAL);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    sent += static_cast<std::size_t>(size);
  }
  return true;
}

std::optional<std::string> RunConnection::next_line(double timeout) {
  const std::int64_t deadline = clock::monotonic_ns() + static_cast<std::int64_t>(timeout * clock::kSecond);
  for (;;) {
    if (auto line = take_line()) return line;
    const std::int64_t rest = deadline - clock::monotonic_ns();
    if (timeout >= 0 && rest <= 0) throw std::runtime_error(path_.string() + ": the run does not answer");
    pollfd entry{fd_, POLLIN, 0};
    if (poll(&entry, 1, timeout < 0 ? -1 : static_cast<int>(rest / 1000000) + 1) <= 0) continue;
    char buffer[4096];
    const ssize_t size = recv(fd_, buffer, sizeof buffer, 0);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return std::nullopt;
    incoming_.append(buffer, static_cast<std::size_t>(size));
  }
}

bool RunConnection::read_lines(std::vector<std::string>& lines) {
  char buffer[65536];
  ssize_t size = 0;
  while ((size = recv(fd_, buffer, sizeof buffer, MSG_DONTWAIT)) > 0)
    incoming_.append(buffer, static_cast<std::size_t>(size));
  const bool ended = size == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
  while (auto line = take_line()) lines.push_back(std::move(*line));
  return !ended;
}

std::optional<std::string> RunConnection::take_line() {
  const std::size_t end = incoming_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = incoming_.substr(0, end);
  incoming_.erase(0, end + 1);
  return line;
}

}  // namespace mrroc::cli
