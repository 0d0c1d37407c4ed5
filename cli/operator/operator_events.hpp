#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/operator/robot_orders.hpp"
#include "cli/operator/trajectories.hpp"
#include "clock/emergency_stop.hpp"
#include "clock/tick_events.hpp"
#include "config/deployment.hpp"
#include "links/exchange/operator_responder.hpp"
#include "links/exchange/task_superior.hpp"

namespace mrroc::cli {

/// The state of the task as far as the operator's commands determine it.
enum class TaskPhase {
  starting,  ///< the processes are being started
  held,      ///< everything is ready, the task waits for `start`
  running,
  paused,
  stopping  ///< the operator or an event has requested the end
};

/// "starting", "held", ... Any thread.
const char* name_of(TaskPhase phase) noexcept;

/// Carries the operator's commands into the deployment, those of its [[events]] and live ones by one path: each takes
/// effect at the beginning of a tick, before any process sees that tick, so that a run with the same commands at the
/// same ticks is the same run. Under the real clock an emergency stop does not wait for the tick.
class OperatorEvents {
 public:
  /// Where answers are sent, by asker.
  using AnswerLinks = std::map<std::string, std::unique_ptr<links::OperatorResponder>>;
  /// Why a command has no effect at its tick, and what would permit it.
  struct Refused {
    const char* text = nullptr;  ///< null: it has taken effect
    const char* expected = "";
  };
  /// A command that has taken effect, or was refused at its tick.
  struct Performed {
    config::Event event;       ///< with the tick at which it took effect
    std::uint64_t ticket = 0;  ///< of `give`; 0: an event of the deployment
    std::uint64_t number = 0;  ///< of an order to a robot, by RobotOrders; of a trajectory, by Trajectories
    Refused refused{};
  };

  /// The deployment's clock as far as it is needed here.
  struct Schedule {
    std::function<void(Tick tick, clock::TickEvents::Callback callback)> at_tick;  ///< as ClockHost::at_tick
    std::function<Tick()> now;                                                     ///< as ClockHost::tick
  };

  /// All must outlive the last tick. `real`: the deployment's clock is the real one.
  OperatorEvents(Schedule schedule, clock::EmergencyStop& emergency_stop, links::TaskSuperior& mp, AnswerLinks& answers,
                 RobotOrders& robots, Trajectories& trajectories, bool real);

  /// Whether every press and reset of the emergency stop has arrived at every host; asked by any thread. Without this
  /// call there is no other host. Before `schedule`.
  void emergency_stop_arrives_when(std::function<bool()> arrived) { arrived_ = std::move(arrived); }
  bool emergency_stop_arrived() const { return arrived_(); }

  /// Receives every command that takes effect, with its tick, before a process sees that tick; in the thread that
  /// performs it, or under the real clock also another one. Before `schedule`.
  void report_to(std::function<void(const config::Event& event)> report) { report_ = std::move(report); }

  /// Schedules the start at tick 0, unless `hold` or one of the events is a start, and the deployment's events. Call it
  /// before the clock starts. Main thread.
  void schedule(const config::Deployment& deployment, bool hold);
  /// A live command, for the next tick. Returns its ticket. Main thread.
  std::uint64_t give(const config::Event& event);
  /// The commands that have taken effect or were refused since the last call, in their order. Main thread.
  std::vector<Performed> take_performed();

  /// The newest tick. Any thread.
  Tick tick() const { return schedule_.now(); }
  /// Any thread.
  TaskPhase phase() const noexcept { return phase_.load(); }
  /// The speed commanded last, 0..1 of the programmed one. Any thread.
  double speed() const noexcept { return speed_.load(); }
  /// Whether the operator or an event has requested the task to stop. Any thread.
  bool stop_performed() const noexcept { return phase() == TaskPhase::stopping; }
  /// The task was stopped before its start: no process reports it. Any thread.
  bool stopped_before_start() const noexcept { return stopped_before_start_.load(); }
  /// The emergency stop is pressed, as far as the operator is concerned. Any thread.
  bool emergency_stopped() const noexcept { return emergency_stopped_.load(); }

 private:
  /// `stops`: emergency stops that were given before the command; a reset releases no later one.
  void perform(config::Event event, Tick tick, std::uint64_t ticket, std::uint64_t stops);
  void press(Tick tick);
  /// The tick at which a reset due at `tick` takes effect: every servo has checked the emergency stop before.
  Tick tick_of_reset(Tick tick);
  Refused check_order(const std::string& command) const;
  /// Begins to send it, one part a tick. Returns its number.
  std::uint64_t follow(const config::Event& event, Tick tick);
  void send_part(const config::Event& event, std::uint64_t number, std::size_t index, Tick tick);
  void command_task(const std::string& command);

  const Schedule schedule_;
  clock::EmergencyStop& emergency_stop_;
  links::TaskSuperior& mp_;
  AnswerLinks& answers_;
  RobotOrders& robots_;
  Trajectories& trajectories_;
  const bool real_;
  std::function<bool()> arrived_ = [] { return true; };
  std::function<void(const config::Event& event)> report_ = [](const config::Event&) {};
  std::mutex mutex_;
  std::atomic<std::uint64_t> stops_given_{0};  ///< emergency stops
  std::uint64_t stops_performed_ = 0;
  std::optional<Tick> press_arrived_;  ///< the tick at which the last press was known to be at every host
  std::vector<Performed> performed_;
  std::uint64_t tickets_ = 0;
  std::atomic<TaskPhase> phase_{TaskPhase::starting};
  std::atomic<double> speed_{1};
  std::atomic<bool> stopped_before_start_{false};
  std::atomic<bool> emergency_stopped_{false};
};

}  // namespace mrroc::cli
