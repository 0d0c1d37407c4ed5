#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/output/output.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::cli {

/// What the operator sees while a deployment runs: on a terminal one live line per process, redrawn in place; otherwise
/// one plain line for each change of a process's state or instruction. It never waits for who reads, and an output that
/// fails is no failure of the run. Text from elsewhere is made printable. Main thread.
class Progress {
 public:
  /// `quiet`: shows nothing but messages. `output`: the descriptor of all but the errors, which go to stderr.
  Progress(std::vector<std::string> processes, double servo_period, bool quiet, int output = 1);
  /// Waits up to 2 s for what is not written yet.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(const links::ProcessStatus& status);
  /// A line of text above the live lines: output of a process, a notice. Shown even when quiet.
  void message(const std::string& text);
  /// A line on stderr, with the live lines out of its way.
  void error(const std::string& text);
  /// Redraws the live lines and writes what could not be written before; call it a few times per second.
  void draw();
  /// While paused there are no live lines: what the operator types is not overwritten.
  void pause(bool paused);
  /// Leaves the live lines as they are and writes below from now on.
  void finish();

 private:
  /// What takes the live lines away.
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
  std::size_t drawn_lines_ = 0;
};

}  // namespace mrroc::cli
