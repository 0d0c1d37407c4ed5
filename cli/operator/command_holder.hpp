#pragma once

#include <cstdint>
#include <string>

namespace mrroc::cli {

/// A client of the operator service: the run's own terminal, or a connection to its socket.
struct OperatorClient {
  std::uint64_t number = 0;  ///< unique in a run; 0: the run's own terminal
  std::string name;          ///< for people: "the terminal", "mrroc_panel (process 4711)"
};

/// Which client commands the deployment: the one that has taken command, until it gives it back or disconnects.
/// While no client holds it, any client may command, one verb at a time. Main thread.
class CommandHolder {
 public:
  bool free() const noexcept { return !held_; }
  bool held_by(const OperatorClient& client) const noexcept { return held_ && holder_.number == client.number; }
  /// Whether the client may command now.
  bool allows(const OperatorClient& client) const noexcept { return free() || held_by(client); }
  /// Name of the holder; empty when command is free.
  const std::string& name() const noexcept { return holder_.name; }

  /// Returns false when another client holds command.
  bool take(const OperatorClient& client) {
    if (!allows(client)) return false;
    held_ = true;
    holder_ = client;
    return true;
  }
  /// Returns false when the client does not hold command.
  bool release(const OperatorClient& client) {
    if (!held_by(client)) return false;
    held_ = false;
    holder_ = {};
    return true;
  }

 private:
  bool held_ = false;
  OperatorClient holder_;
};

}  // namespace mrroc::cli
