#pragma once

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/types.h>
#include <sys/wait.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::test {

/// Holds threads of a process until its own destruction, like a debugger at a breakpoint: no process is notified, no
/// signal is sent.
class HeldThreads {
 public:
  enum class Which { all, newest };

  explicit HeldThreads(pid_t pid, Which which = Which::all) {
    std::vector<pid_t> ids;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/" + std::to_string(pid) + "/task"))
      ids.push_back(std::stoi(thread.path().filename()));
    std::sort(ids.begin(), ids.end());
    if (which == Which::newest) ids.erase(ids.begin(), ids.end() - 1);
    for (const pid_t id : ids) {
      if (ptrace(PTRACE_SEIZE, id, nullptr, nullptr) != 0) continue;  // the thread ends
      threads_.push_back(id);
      EXPECT_EQ(ptrace(PTRACE_INTERRUPT, id, nullptr, nullptr), 0);
    }
    int status = 0;
    for (const pid_t id : threads_) waitpid(id, &status, __WALL);
  }
  ~HeldThreads() {
    // the first thread is reaped last, by the parent
    for (auto id = threads_.rbegin(); id != threads_.rend(); ++id)
      if (ptrace(PTRACE_DETACH, *id, nullptr, nullptr) != 0) waitpid(*id, nullptr, __WALL);
  }
  HeldThreads(const HeldThreads&) = delete;
  HeldThreads& operator=(const HeldThreads&) = delete;

  std::size_t count() const { return threads_.size(); }

 private:
  std::vector<pid_t> threads_;
};

}  // namespace mrroc::test
