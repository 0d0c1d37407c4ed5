#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "cli/processes/child.hpp"

namespace mrroc::cli {

struct PanelOptions {
  int port = 0;                       ///< 0: any free one
  std::string interface;              ///< network device or own address; empty: this machine only
  std::filesystem::path certificate;  ///< PEM file for TLS; empty: without
};

/// The command line of `mrroc_panel` for these options. Any thread.
std::vector<std::string> panel_arguments(const PanelOptions& options);
/// The path of `mrroc_panel`. Throws std::runtime_error when it is not installed. Any thread.
std::string panel_program();

/// The server of the operator's panel as a process beside those of the deployment: only the run's socket feeds it, and
/// its end is not an error of the run. Main thread.
class PanelProcess {
 public:
  using Show = std::function<void(const std::string& line)>;

  /// `socket`: of the run. Throws std::runtime_error when it cannot be started.
  PanelProcess(const PanelOptions& options, const std::filesystem::path& socket, Show show);
  /// Gives it a moment to tell its browsers that the run has ended.
  ~PanelProcess();

  /// Shows its lines, and once that it has ended. Never waits.
  void poll();
  /// Whether it serves its URL, or has ended before.
  bool started() const noexcept { return serves_ || ended_; }
  bool ended() const noexcept { return ended_; }
  /// Why it has ended.
  const std::string& last_line() const noexcept { return child_.last_line(); }

 private:
  Child child_;
  Show show_;
  bool serves_ = false;
  bool ended_ = false;
};

}  // namespace mrroc::cli
