#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "cli/operator/verb_reply.hpp"

namespace mrroc::cli {

/// A client's connection to the operator socket of a run on this machine. One thread.
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

  const std::string& deployment() const noexcept { return deployment_; }
  int pid() const noexcept { return pid_; }
  /// Sends a request and returns its reply. Throws std::runtime_error when none comes within 10 s.
  VerbReply request(std::string_view verb, const std::map<std::string, std::string>& arguments = {});
  /// The next line, when it comes within `timeout` s (negative: whenever); null at the end of the connection. Throws
  /// std::runtime_error when it does not come in time.
  std::optional<std::string> next_line(double timeout);

 private:
  std::filesystem::path path_;
  int fd_ = -1;
  std::string deployment_;
  int pid_ = 0;
  std::string incoming_;
};

}  // namespace mrroc::cli
