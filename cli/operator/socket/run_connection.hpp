#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/operator/verb_reply.hpp"

namespace mrroc::cli {

/// A client's connection to the operator socket of a run on this machine. One thread, besides `send_line`.
class RunConnection {
 public:
  /// Connects to the run of this deployment, by its name or as "name-pid"; an empty name: the only run. Throws
  /// std::runtime_error when there is none or more than one, and lists those that run.
  static RunConnection to(const std::string& deployment);
  /// Connects to this socket. Throws std::runtime_error when the run does not answer within 5 s or has another
  /// protocol.
  explicit RunConnection(const std::filesystem::path& socket);
  ~RunConnection();
  RunConnection(RunConnection&& other) noexcept;
  RunConnection& operator=(RunConnection&&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  const std::string& deployment() const noexcept { return deployment_; }
  int pid() const noexcept { return pid_; }
  /// How the run names this client.
  const std::string& client() const noexcept { return client_; }
  /// Becomes readable when the run has sent something that `next_line` does not yet have.
  int descriptor() const noexcept { return fd_; }
  /// Sends a request and returns its reply. Throws std::runtime_error at the end of the connection, and when no reply
  /// comes within 10 s; that of a verb that lasts may come later. `slow` is called once when none has come after 2 s.
  VerbReply request(std::string_view verb, const std::map<std::string, std::string>& arguments = {},
                    const std::function<void()>& slow = {});
  /// Sends one line of the protocol, without its end. It waits while the run reads this client slowly; false at the end
  /// of the connection. Another thread than that of `next_line` may call it.
  bool send_line(const std::string& line);
  /// The next line, when it comes within `timeout` s (negative: whenever); null at the end of the connection. Throws
  /// std::runtime_error when it does not come in time.
  std::optional<std::string> next_line(double timeout);
  /// Appends the whole lines that have come, without waiting; false at the end of the connection.
  bool read_lines(std::vector<std::string>& lines);

 private:
  /// Takes a whole line from `incoming_`.
  std::optional<std::string> take_line();

  std::filesystem::path path_;
  int fd_ = -1;
  std::string deployment_;
  int pid_ = 0;
  std::string client_;
  std::string incoming_;
};

}  // namespace mrroc::cli
