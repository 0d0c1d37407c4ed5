#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/processes/child.hpp"

namespace mrroc::cli {

/// A process beside those of the deployment, such as the panel's server: only the run's socket feeds it, and its end is
/// not an error of the run. It prints a line "NAME: ..." once it serves. Main thread.
class SideProcess {
 public:
  using Show = std::function<void(const std::string& line)>;

  /// `socket`: of the run, handed to the program behind its `words`. Throws std::runtime_error when it cannot be
  /// started.
  SideProcess(std::string name, const std::string& program, std::vector<std::string> words,
              const std::filesystem::path& socket, Show show);
  /// Gives it a moment for its last messages to its own clients.
  ~SideProcess();

  /// Shows its lines once it serves, and that it has ended. Never waits.
  void poll();
  /// Whether it serves, or has ended before.
  bool started() const noexcept { return serves_ || ended_; }
  bool ended() const noexcept { return ended_; }
  /// Why it has ended.
  const std::string& last_line() const noexcept { return child_.last_line(); }

 private:
  std::string name_;
  Child child_;
  Show show_;
  std::vector<std::string> lines_;  // not yet shown
  bool serves_ = false;
  bool ended_ = false;
};

}  // namespace mrroc::cli
