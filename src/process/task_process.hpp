#pragma once

#include <exception>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "links/exchange/robot_requester.hpp"
#include "links/exchange/sensor_requester.hpp"
#include "links/exchange/task_subordinate.hpp"
#include "mrroc/task.hpp"
#include "process/dialogue.hpp"
#include "process/faulty_robot_link.hpp"
#include "process/mailbox.hpp"
#include "process/process.hpp"
#include "process/record/step_reporter.hpp"
#include "process/task_trajectories.hpp"

namespace mrroc::process {

/// The language's `Task` over a Process: common part of ECP and MP tasks. Opens links when robots and sensors are
/// built, and processes the commands of its superior (the MP, or the operator) at every step. Task's thread.
class TaskProcess : public Task {
 public:
  /// `superior_topic`: topic on which this process is started, paused, stopped.
  TaskProcess(Process& process, const std::string& superior_topic);
  ~TaskProcess() override;

  Process& process() const noexcept { return process_; }
  /// The link on which the superior starts, pauses and stops the task.
  links::TaskSubordinate& task_link() noexcept { return task_link_; }

  /// Handshakes with every robot and sensor that the task has opened a link to. After the task object is built. Throws
  /// SystemError naming the peer that does not answer.
  void connect_links();

  /// Waits, for a second of ticks at most, until every publishing sensor has sent a reading. Called before a task
  /// begins, so that its first instruction finds readings. A silent sensor is reported by the instruction that uses it.
  /// Throws Stopped.
  void await_published_sensors();

  /// Takes the superior's commands that have arrived; returns true when one of them is `start`.
  bool read_superior();
  /// The behaviour of the last `start`; without label: the program itself.
  const Message& started() const noexcept { return started_; }
  /// Reports the task's state to the superior.
  void report(links::TaskState state);
  /// Reports to it the failure of the task, its reason and its origin: this process unless `error` names another. Also
  /// reports the error on stderr, with the file of the black box.
  void report_failure(const std::exception& error);

  // ---- the operator's dialogue, for the program; any of them may throw NonFatalError(invalid_argument), see Dialogue
  /// Shows the operator a message of at most 127 characters; does not wait.
  void tell_operator(const std::string& text) { dialogue_.tell(text); }
  /// Asks the operator, and waits for the answer: the robots hold, pause and stop take effect. Throws Stopped. In CI
  /// the deployment's [[answers]] answer.
  bool ask_yes_no(const std::string& question);
  /// The index of one of at most 8 choices of at most 31 characters each.
  std::size_t ask_choice(const std::string& question, const std::vector<std::string>& choices);
  /// A number from `minimum` to `maximum`.
  double ask_number(const std::string& question, double minimum, double maximum);

  // ---- Task
  // ------------------------------------------------------------------------------------------------------------
  const std::string& process_name() const noexcept override { return process_.name(); }
  std::filesystem::path robot_parameters(const std::string& name, const std::string& type) const override;
  Load robot_load(const std::string& name) const override;
  MeasuredArm measured_arm(const std::string& name) const override;
  RobotLink& robot_link(const std::string& name, const std::string& type) override;
  SensorLink& sensor_link(const std::string& name, const std::string& type, bool& interactive) override;
  double servo_period() const noexcept override { return process_.clock().period(); }
  Tick tick() const noexcept override { return process_.clock().tick(); }
  double wall_seconds() const noexcept override { return process_.clock().wall_seconds(); }
  void sleep_until(Tick tick) override;
  OperatorRequest operator_request() override;
  double operator_speed() const noexcept override { return speed_; }
  bool take_trigger() override;
  StepObserver* observer() noexcept override { return reporter_.get(); }
  TrajectoryLink* trajectory_link() noexcept override { return &trajectories_; }

 protected:
  /// The superior's messages to the running program.
  Mailbox& mailbox() noexcept { return mailbox_; }
  /// Waits until `holds`, checked whenever something has arrived, and the task is not paused. Throws Stopped when the
  /// task should end.
  void wait_until(const std::function<bool()>& holds);
  /// False while the task is paused; throws Stopped when it should end.
  bool may_go_on();

  /// Topic prefix of the link to robot `name` at this level.
  virtual std::string robot_topic(const std::string& name) const = 0;
  /// Name of the process at the other end, for errors.
  virtual std::string robot_peer(const std::string& name) const = 0;
  /// Called at every step: takes the level's own messages (an MP's ECPs, an ECP's MP).
  virtual void poll_others() {}
  /// Called for each command of the superior, after the task has taken note of it.
  virtual void on_superior_command(const links::TaskCommand& /*command*/) {}

 private:
  /// Writes the error's black box, or else the task's present one. Returns the text about it for the report; may be
  /// empty.
  std::string save_black_box(const Error* error) const;
  double put_question(links::OperatorQuestion question, const std::string& text);
  /// Throws NonFatalError(invalid_argument) once the links are connected.
  void check_not_started(const char* kind, const std::string& name) const;
  /// Ticks after which a peer that does not answer counts as silent.
  Tick patience() const;

  Process& process_;
  links::TaskSubordinate task_link_;
  Dialogue dialogue_;
  TaskTrajectories trajectories_;
  Mailbox mailbox_;
  Message started_;
  bool running_ = false;  // since `start` came, until the end is reported
  std::unique_ptr<StepReporter> reporter_;
  /// Links cannot be opened any more: the other side waits for its clients before the start only. From then on the maps
  /// below do not change.
  bool connected_ = false;
  std::map<std::string, std::unique_ptr<links::RobotRequester>> robots_;
  std::map<std::string, FaultyRobotLink> faulty_;
  std::map<std::string, std::unique_ptr<links::SensorRequester>> sensors_;
  OperatorRequest request_ = OperatorRequest::none;
  std::uint32_t triggers_ = 0;
  double speed_ = 1;  // that the operator wants
};

}  // namespace mrroc::process
