#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "cli/operator/terminal/line_editor.hpp"
#include "cli/operator/terminal/terminal_mode.hpp"

namespace mrroc::cli {

/// Lines that the operator types at a terminal or a process writes into a pipe: `mrroc run`'s standard input. Keeps the
/// newest 64 KiB of the lines that were not taken; of a file, all. One thread.
class ConsoleInput {
 public:
  /// `fd`: not owned. `keys`: on a terminal, take single keys and edit the line here; the caller shows it.
  explicit ConsoleInput(int fd, bool keys = false);

  /// Whether a line may come: the descriptor is a terminal, a pipe or a file (not /dev/null), and its end has not been
  /// reached.
  bool attended() const noexcept;
  /// Whether single keys are taken; then `typed` is the line so far.
  bool takes_keys() const noexcept { return mode_ && mode_->active(); }
  const std::string& typed() const noexcept { return editor_.text(); }
  /// The next whole line, without its end; the last one may lack it. " " is the space key on an empty line. Never
  /// waits, and does not read a terminal while this process is in its background.
  std::optional<std::string> next();
  /// Removes and returns the first whole line, without blanks around it, that `wanted` accepts; other lines stay. For
  /// commands that must not wait behind lines that nothing has requested yet. Never waits.
  std::optional<std::string> next_if(const std::function<bool(std::string_view line)>& wanted);

 private:
  void read_more();
  void forget_oldest();

  int fd_;
  std::optional<TerminalMode> mode_;
  LineEditor editor_;
  bool ended_ = false;
  std::string unread_;
};

}  // namespace mrroc::cli
