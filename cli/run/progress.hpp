#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cli/output/output.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::cli {

/// The display of a running deployment: on a terminal one live line per process, redrawn in place; otherwise one plain
/// line for each change of a process's state or instruction. Output never blocks the run, and a failed output does not
/// fail it. Text from other processes is made printable. Main thread.
class Progress {
 public:
  /// `quiet`: shows only messages. `output`: the descriptor of all but the errors, which go to stderr.
  Progress(std::vector<std::string> processes, double servo_period, bool quiet, int output = 1);
  /// Waits up to 2 s to write the remaining text.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// From now on `listener` also receives the text of every message and error.
  void listen(std::function<void(const std::string& text)> listener) { listener_ = std::move(listener); }
  void update(const links::ProcessStatus& status);
  /// A line of text above the live lines: output of a process, a notice. Shown even when quiet.
  void message(const std::string& text);
  /// The same without the listener: what it has received in another way.
  void notice(const std::string& text);
  /// A line on stderr, with the live lines removed while it is written.
  void error(const std::string& text);
  /// Redraws the live lines and writes text that could not be written before; call it a few times per second.
  void draw();
  /// The last line of the display on a terminal: what the operator types. Empty: none.
  void prompt(const std::string& text);
  /// Whether there are live lines: the output is a terminal.
  bool live() const noexcept { return live_; }
  /// While paused there are no live lines: the operator's typed text is not overwritten.
  void pause(bool paused);
  /// Leaves the live lines unchanged and writes below them from now on.
  void finish();

 private:
  /// The control text that removes the live lines.
  std::string erasure();
  void print_change(const links::ProcessStatus& before, const links::ProcessStatus& now);

  Output out_;
  Output err_;
  std::vector<std::string> names_;
  double servo_period_;
  bool quiet_;
  bool live_;  // the output is a terminal
  bool paused_ = false;
  std::map<std::string, links::ProcessStatus> statuses_;
  std::function<void(const std::string& text)> listener_ = [](const std::string&) {};
  std::string prompt_;
  std::size_t drawn_lines_ = 0;
  bool prompt_drawn_ = false;
};

}  // namespace mrroc::cli
