#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace mrroc::cli {

/// One process that the runner has started. It cannot outlive the runner: the kernel terminates it when the runner's
/// main thread ends, however that happens (PR_SET_PDEATHSIG). Main thread only.
class Child {
 public:
  /// Starts `program`; `output_fd()` delivers its stdout and stderr. `channel`: a descriptor that becomes its stdin and
  /// stdout, so that `output_fd()` delivers only stderr; -1: none. `handed`: close-on-exec descriptors that it inherits
  /// nevertheless, under the same numbers. Throws std::runtime_error when it cannot be started.
  Child(std::string name, const std::string& program, const std::vector<std::string>& arguments, int channel = -1,
        const std::vector<int>& handed = {});
  ~Child();
  Child(Child&& other) noexcept;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  Child& operator=(Child&&) = delete;

  const std::string& name() const noexcept { return name_; }
  pid_t pid() const noexcept { return pid_; }
  int output_fd() const noexcept { return output_; }

  /// True when it has ended; then `how_it_ended()` and `exit_code()` report how. Never waits.
  bool ended() noexcept;
  /// True when it has ended, or a signal has stopped it (SIGSTOP). The kernel reports both to the runner at once, by
  /// SIGCHLD. Never waits.
  bool lost() noexcept;
  /// False once all of its threads have ended: a process that is stopped lives. Any thread. Never waits.
  bool lives() const noexcept;
  /// False once `lost()` returns true, and only then: no thread of it runs any more. Any thread; it leaves the kernel's
  /// report for the main thread. Never waits.
  bool is_at_work() const;
  /// True when it is going to end: it has been killed, has ended but for its memory and files, or writes a core file. A
  /// busy machine takes seconds for that, in which it is silent. Main thread. Never waits.
  bool is_dying() const;
  /// "exit code 3", "signal 9 (Killed)" or "stopped by signal 19 (Stopped (signal))".
  std::string how_it_ended() const;
  /// Once it is lost: "died: exit code 3: its last line", "is stopped by signal 19 (Stopped (signal))".
  std::string how_it_was_lost() const;
  /// Nothing when it still runs or a signal has ended it.
  std::optional<int> exit_code() const noexcept;
  /// The last line that `read_lines` returned; for a process that gives up, the reason.
  const std::string& last_line() const noexcept { return last_line_; }
  /// Any thread; never signals another process that has reused its number.
  void signal(int number) const noexcept;
  /// Whole lines that it has written since the last call; at its end also an unfinished one. A line of more than 64 KB
  /// comes in pieces. Never waits.
  std::vector<std::string> read_lines();
  /// Waits until it has ended; returns every line that it has written.
  std::string wait_for_output();

 private:
  void poll() noexcept;

  std::string name_;
  pid_t pid_ = -1;
  int handle_ = -1;  ///< pidfd
  int output_ = -1;
  bool ended_ = false;
  bool stopped_ = false;
  int status_ = 0;  ///< of its end or stop
  std::string unfinished_;
  std::string last_line_;
};

}  // namespace mrroc::cli
