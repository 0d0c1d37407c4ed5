#pragma once

#include <deque>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "cli/processes/child.hpp"
#include "cli/processes/process_plan.hpp"
#include "clock/host.hpp"

namespace mrroc::cli {

/// The processes of a run. Main thread only.
class ProcessGroup {
 public:
  /// Called with each whole line that a process writes.
  using Listener = std::function<void(const std::string& name, const std::string& line)>;
  explicit ProcessGroup(Listener listener) : listener_(std::move(listener)) {}

  /// `handed`: descriptors for it (see Child). Throws std::runtime_error when it cannot be started.
  void start(const PlannedProcess& process, const std::vector<std::string>& arguments,
             const std::vector<int>& handed = {});
  /// Null when no process has that name. Any thread, once all have been started.
  const Child* find(const std::string& name) const noexcept;
  /// Waits until a process writes or ends, one of `also` becomes readable, or the time is over; forwards the lines.
  void wait(int milliseconds, std::initializer_list<int> also);
  void wait(int milliseconds, int also) { wait(milliseconds, {also}); }
  /// A process that has ended or been stopped, with all its output forwarded; null when all are running. Prefers one of
  /// `suspects`.
  Child* first_lost(const std::vector<std::string>& suspects = {});
  bool all_ended() noexcept;
  /// Those of this part that failed: ended with an exit code or by a signal, or stopped by one. All their output is
  /// forwarded.
  std::vector<Child*> failed(clock::Part part);
  /// Whether every process of this part is lost or has left the clock. One that has left may take seconds to end on a
  /// busy machine.
  bool all_left(clock::Part part, const clock::ClockHost& clock) noexcept;
  void signal(int number) noexcept;
  void signal(int number, clock::Part part) noexcept;
  /// Kills those that a signal has stopped: they cannot end on their own. Returns their names.
  std::vector<std::string> kill_stopped() noexcept;
  /// Kills those that still run; returns their names.
  std::vector<std::string> kill_rest() noexcept;

 private:
  struct Member {
    Child child;
    clock::Part part;
  };
  void listen(Child& child);
  template <class Predicate>
  std::vector<std::string> kill_those(Predicate predicate) noexcept;

  Listener listener_;
  std::deque<Member> members_;
};

}  // namespace mrroc::cli
