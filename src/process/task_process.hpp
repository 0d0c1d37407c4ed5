#pragma once

#include <exception>
#include <map>
#include <memory>
#include <string>

#include "links/robot_requester.hpp"
#include "links/sensor_requester.hpp"
#include "links/task_subordinate.hpp"
#include "mrroc/task.hpp"
#include "process/process.hpp"
#include "process/step_reporter.hpp"

namespace mrroc::process {

/// The language's `Task` over a Process: what ECP and MP tasks have in common. Opens links when robots and sensors are
/// built, listens to its superior (the MP, or the operator) at every step. The task's thread.
class TaskProcess : public Task {
 public:
  /// `superior_topic`: where this process is started, paused, stopped.
  TaskProcess(Process& process, const std::string& superior_topic);
  ~TaskProcess() override;

  Process& process() const noexcept { return process_; }
  links::TaskSubordinate& superior() noexcept { return superior_; }

  /// Handshakes with every robot and sensor that the task has opened a link to. After the task object is built. Throws
  /// SystemError naming the peer that does not answer.
  void connect_links();

  /// Waits, for a second of ticks at most, until every sensor that publishes has been heard once: before a task begins,
  /// so that its first instruction does not meet a sensor without a reading. One that stays silent is met by the
  /// instruction that uses it. Throws Stopped.
  void await_published_sensors();

  /// Takes the commands of the superior that have come; returns true when one of them is `start`.
  bool read_superior();
  /// Tells the superior how the task stands.
  void report(links::TaskState state);
  /// Tells it that the task has failed, why, and where that arose: in this process unless `error` names another.
  void report_failure(const std::exception& error);

  // ---- Task
  // ------------------------------------------------------------------------------------------------------------
  const std::string& process_name() const noexcept override { return process_.name(); }
  RobotLink& robot_link(const std::string& name, const std::string& type) override;
  SensorLink& sensor_link(const std::string& name, const std::string& type, bool& interactive) override;
  double servo_period() const noexcept override { return process_.clock().period(); }
  Tick tick() const noexcept override { return process_.clock().tick(); }
  double wall_seconds() const noexcept override { return process_.clock().wall_seconds(); }
  void sleep_until(Tick tick) override;
  OperatorRequest operator_request() override;
  bool take_trigger() noexcept override;
  StepObserver* observer() noexcept override { return reporter_.get(); }

 protected:
  /// Topic prefix of the link to robot `name` at this level.
  virtual std::string robot_topic(const std::string& name) const = 0;
  /// Name of the process at the other end, for errors.
  virtual std::string robot_peer(const std::string& name) const = 0;
  /// Called at every step: the level's own mail (an MP's ECPs, an ECP's MP).
  virtual void poll_others() {}
  /// Called for each command of the superior, after the task has taken note of it.
  virtual void on_superior_command(const links::TaskCommand& /*command*/) {}

 private:
  Process& process_;
  links::TaskSubordinate superior_;
  std::unique_ptr<StepReporter> reporter_;
  std::map<std::string, std::unique_ptr<links::RobotRequester>> robots_;
  std::map<std::string, std::unique_ptr<links::SensorRequester>> sensors_;
  OperatorRequest request_ = OperatorRequest::none;
  std::uint32_t triggers_ = 0;
};

}  // namespace mrroc::process
