#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "cli/child.hpp"

namespace mrroc::cli {

/// The processes of a run. Main thread only.
class Crew {
 public:
  /// Is given each whole line that a process writes.
  using Listener = std::function<void(const std::string& name, const std::string& line)>;
  explicit Crew(Listener listener) : listener_(std::move(listener)) {}

  /// Throws std::runtime_error when it cannot be started.
  void start(const std::string& name, const std::string& program, const std::vector<std::string>& arguments);
  /// Waits until a process writes or ends, `also` becomes readable, or the time is over; hands the lines on.
  void wait(int milliseconds, int also);
  /// A process that has ended, with all that it has written handed on; null when all live.
  Child* first_ended();
  bool all_ended() noexcept;
  void signal(int number) noexcept;
  /// Kills those that still live; gives their names.
  std::vector<std::string> kill_rest() noexcept;

 private:
  void listen(Child& child);

  Listener listener_;
  std::deque<Child> children_;
};

}  // namespace mrroc::cli
