#pragma once

#include <termios.h>

namespace mrroc::cli {

/// While it exists a terminal gives every key at once and shows none: a program that edits the line itself can keep
/// its display in order. Ctrl-C still sends its signal. Restores the terminal at the end. Main thread.
class TerminalMode {
 public:
  /// Does nothing when `fd` is not a terminal, or this process is in its background.
  explicit TerminalMode(int fd) noexcept;
  ~TerminalMode();
  TerminalMode(const TerminalMode&) = delete;
  TerminalMode& operator=(const TerminalMode&) = delete;

  bool active() const noexcept { return active_; }

 private:
  int fd_;
  bool active_ = false;
  termios before_{};
};

}  // namespace mrroc::cli
