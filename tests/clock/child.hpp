#pragma once

#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <utility>

namespace mrroc::clock {

/// A forked process that runs `body` and exits; killed with this object when it still exists.
class Child {
 public:
  explicit Child(const std::function<void()>& body) : pid_(::fork()) {
    if (pid_ != 0) return;
    body();
    ::_exit(0);
  }
  Child(Child&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}
  Child& operator=(Child&&) = delete;
  ~Child() { kill(); }

  /// True: it ran to its end.
  bool join() {
    int status = -1;
    if (pid_ > 0) ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  /// Stops it at any point; afterwards it stands still.
  void stop() {
    ::kill(pid_, SIGSTOP);
    ::waitpid(pid_, nullptr, WUNTRACED);
  }
  /// Stops it as a debugger does at a breakpoint, for so many seconds.
  void hold(unsigned seconds) {
    ::ptrace(PTRACE_SEIZE, pid_, nullptr, nullptr);
    ::ptrace(PTRACE_INTERRUPT, pid_, nullptr, nullptr);
    ::waitpid(pid_, nullptr, 0);
    ::sleep(seconds);
    ::ptrace(PTRACE_DETACH, pid_, nullptr, nullptr);
  }
  void go_on() { ::kill(pid_, SIGCONT); }
  /// Sends SIGKILL; afterwards the process no longer exists.
  void kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    join();
  }

 private:
  pid_t pid_;
};

}  // namespace mrroc::clock
