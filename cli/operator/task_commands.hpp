#pragma once

#include <atomic>
#include <mutex>

#include "cli/operator/operator_console.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "links/exchange/task_superior.hpp"

namespace mrroc::cli {

/// The commands to the MP: start, pause, resume, stop, trigger. They come from the operator at once, and from the
/// deployment's events at their ticks. The main thread, or the clock's.
class TaskCommands {
 public:
  /// `mp` must outlive it.
  explicit TaskCommands(links::TaskSuperior& mp) : mp_(mp) {}

  void send(links::TaskCommandKind kind);
  /// Whether the operator or an event has requested the task to stop. Any thread.
  bool stop_sent() const noexcept { return stop_sent_.load(); }
  /// Schedules the start at tick 0, and the deployment's events for the task and for the operator's `console`. Call it
  /// before the clock starts; all must outlive its last tick.
  void schedule(clock::ClockHost& clock, const config::Deployment& deployment, OperatorConsole& console);

 private:
  links::TaskSuperior& mp_;
  std::mutex mutex_;
  std::atomic<bool> stop_sent_ = false;
};

}  // namespace mrroc::cli
