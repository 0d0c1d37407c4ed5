#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "cli/operator/operator_service.hpp"

namespace mrroc::cli {

/// The operator's socket of a run, `<folder>/<deployment>-<pid>.sock`: lines of JSON,
/// docs/reference/operator-protocol.md. Only processes of the same user, and root, are served. A client that sends too
/// much is read more slowly, one that does not read its lines is disconnected; no client delays the run or another
/// client, and memory is bounded. Main thread.
class OperatorSocket {
 public:
  static constexpr int kProtocol = 1;
  static constexpr std::size_t kMaxClients = 64;
  static constexpr std::size_t kMaxLine = 16384;      ///< bytes of a request
  static constexpr std::size_t kMaxWaiting = 262144;  ///< bytes that a client has not read
  static constexpr std::size_t kLinesPerTurn = 16;    ///< requests of one client between two turns

  /// Creates the socket. Throws std::runtime_error with the path and the reason. `service` outlives it.
  OperatorSocket(OperatorService& service, const std::string& deployment);
  /// Sends what the clients take at once, disconnects them and removes the socket.
  ~OperatorSocket();
  OperatorSocket(const OperatorSocket&) = delete;
  OperatorSocket& operator=(const OperatorSocket&) = delete;

  /// Becomes readable when a client connects or sends something that may be read now.
  int descriptor() const noexcept { return wake_; }
  /// Accepts clients, executes their requests, sends what was not taken before. Never waits.
  void poll();
  /// Sends a line to every watching client.
  void publish(const std::string& json);
  /// The states that clients watch; and a line about one of them for those clients. A client that has not read the
  /// last lines misses this one.
  WatchedStates watched_states() const noexcept;
  void publish_robot(const std::string& json) { publish_state(json, &WatchedStates::robots); }
  void publish_reading(const std::string& json) { publish_state(json, &WatchedStates::readings); }
  void publish_world(const std::string& json) { publish_state(json, &WatchedStates::world); }
  /// Whether a client watches: it can answer questions.
  bool watched() const noexcept;
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  struct Client;

  void publish_state(const std::string& json, bool WatchedStates::*kind);
  void accept_clients();
  /// The name of a new client, for people: of its process, with its number when that process has another connection.
  std::string name_of(const std::string& process) const;
  void serve(Client& client);
  void execute(Client& client, const std::string& line);
  void write(Client& client, const std::string& line);
  void flush(Client& client);
  /// Whether the client's next lines are waited for, or read in a later turn.
  void listen_to(Client& client, bool listen);

  OperatorService& service_;
  std::filesystem::path path_;
  std::string deployment_;
  int listener_ = -1;
  int wake_ = -1;
  std::uint64_t accepted_ = 0;
  std::map<std::uint64_t, std::unique_ptr<Client>> clients_;
};

}  // namespace mrroc::cli
