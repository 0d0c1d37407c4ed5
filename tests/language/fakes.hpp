#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>

#include "language/call_log.hpp"
#include "language/fake_model.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/step_observer.hpp"
#include "mrroc/task.hpp"

namespace mrroc::fakes {

/// The common time of all fakes of a test: it advances to the newest tick of a reply.
struct FakeTime {
  Tick tick = 1000;
  void reach(Tick reached) { tick = std::max(tick, reached); }
};

/// A robot that executes every command exactly: the commanded state is the desired one, and the measured one at the
/// reply.
class FakeRobotLink : public RobotLink {
 public:
  FakeRobotLink(std::string name, int axes, FakeTime& time, CallLog& log)
      : model(std::make_shared<FakeModel>(axes)), name_(std::move(name)), time_(time), log_(log) {
    state.joints = state.joint_velocity = state.motors = state.current = JointVector::Zero(axes);
    state.desired_joints = state.desired_velocity = state.desired_acceleration = JointVector::Zero(axes);
    state.tick = state.desired_tick = time.tick;
    state.synchronised = state.enabled = true;
  }

  void send(const RobotCommand& command) override {
    command_ = command;
    sent_at_ = time_.tick;
    log_.add({Action::send, name_, command.start_tick, command.kind, command.motion_steps, command.reply_step,
              command.joints.size() > 0 ? command.joints[0] : 0.0});
  }

  void receive(RobotState& reply) override {
    log_.add({Action::receive, name_});
    if (received_ == late_at) ++state.late_commands;
    const auto throwing = throws.find(received_);
    const auto error = errors.find(received_++);
    if (throwing != throws.end()) throwing->second();
    if (command_.kind == CommandKind::query || command_.kind == CommandKind::end) {
      state.tick = time_.tick;
      state.desired_tick = std::max(state.desired_tick, time_.tick);
    } else {
      execute();
    }
    state.error = error == errors.end() ? ErrorReport{} : error->second;
    time_.reach(state.tick);
    reply = state;
  }

  std::uint64_t late_at = std::numeric_limits<std::uint64_t>::max();  ///< number of the reply that reports braking
  Tick way = 0;                                                       ///< time until a command arrives
  Tick delayed_start = 0;  ///< reported delay of the start after the commanded tick
  std::shared_ptr<FakeModel> model;
  RobotState state;
  std::map<std::uint64_t, ErrorReport> errors;            ///< by number of the reply, from 0
  std::map<std::uint64_t, std::function<void()>> throws;  ///< by number of the reply: thrown instead of it

 private:
  void execute() {
    const Tick begin = std::max({command_.start_tick, state.desired_tick, sent_at_ + way});
    state.macrostep_start = begin + delayed_start;
    state.tick = begin + command_.reply_step;
    state.desired_tick = std::max<Tick>(begin + command_.motion_steps, state.tick);
    state.desired_velocity.setZero();
    state.desired_acceleration.setZero();
    if (command_.kind == CommandKind::joint) {
      state.desired_joints = command_.joints;
      if (command_.joint_velocity.size() > 0) state.desired_velocity = command_.joint_velocity;
      if (command_.joint_acceleration.size() > 0) state.desired_acceleration = command_.joint_acceleration;
      state.desired_pose = model->flange(state.desired_joints);
    } else if (command_.kind == CommandKind::pose) {
      state.desired_pose = command_.pose;
      model->inverse(command_.pose, state.desired_joints, state.desired_joints);
      const auto linear = std::min<Eigen::Index>(3, state.desired_velocity.size());
      state.desired_velocity.head(linear) = command_.twist.head(linear);
    } else if (command_.kind == CommandKind::force) {
      state.desired_velocity.setConstant(0.01);  // it follows the contact
    }
    state.joints = state.desired_joints;
    state.joint_velocity = state.desired_velocity;
    state.pose = state.desired_pose;
  }

  std::string name_;
  FakeTime& time_;
  CallLog& log_;
  RobotCommand command_;
  Tick sent_at_ = 0;
  std::uint64_t received_ = 0;
};

/// A sensor of one channel. Its n-th reading (from 0) has the value `base + n`, the sequence n + 1.
class FakeSensorLink : public SensorLink {
 public:
  FakeSensorLink(std::string name, double base, FakeTime& time, CallLog& log)
      : base_(base), name_(std::move(name)), time_(time), log_(log) {}

  void request(const SensorRequest& request) override {
    const bool bias = request.kind == SensorRequestKind::bias;
    log_.add({bias ? Action::bias : Action::request, name_, request.measure_at});
    measure_at_ = std::max(request.measure_at, time_.tick);
  }
  void receive(SensorReading& reading) override {
    log_.add({Action::collect, name_});
    read(reading, measure_at_);
    time_.reach(measure_at_);
  }
  bool latest(SensorReading& reading) override {
    log_.add({Action::latest, name_});
    if (taken_ < ready_from) {
      ++taken_;
      return false;
    }
    read(reading, time_.tick);
    return true;
  }

  bool polled() const noexcept override { return is_polled; }
  bool poll(SensorReading& reading) override {
    log_.add({Action::collect, name_});
    if (late > 0) return --late, false;
    read(reading, measure_at_);
    return true;
  }

  bool interactive = true;
  bool is_polled = false;
  int late = 0;                                 ///< polled: so many queries find no reading
  std::uint64_t ready_from = 0;                 ///< non-interactive: number of the first available reading
  std::map<std::uint64_t, ErrorReport> errors;  ///< by number of the reading, from 0

 private:
  void read(SensorReading& reading, Tick tick) {
    reading.tick = tick;
    reading.channel_count = 1;
    reading.values[0] = base_ + static_cast<double>(taken_);
    const auto error = errors.find(taken_++);
    reading.error = error == errors.end() ? ErrorReport{} : error->second;
    reading.sequence = taken_;
  }

  double base_;
  std::string name_;
  FakeTime& time_;
  CallLog& log_;
  Tick measure_at_ = 0;
  std::uint64_t taken_ = 0;
};

/// A task with fakes. Robots and sensors are added before the Robot and Sensor objects are built.
class FakeTask : public Task {
 public:
  explicit FakeTask(std::string process = "test") : process_(std::move(process)) {}

  FakeRobotLink& add_robot(const std::string& name, int axes = 6) {
    return *(robots_[name] = std::make_unique<FakeRobotLink>(name, axes, time, log));
  }
  FakeSensorLink& add_sensor(const std::string& name, bool interactive = true, double base = 0) {
    auto& sensor = *(sensors_[name] = std::make_unique<FakeSensorLink>(name, base, time, log));
    sensor.interactive = interactive;
    return sensor;
  }
  /// A Robot on the link of that name, added when it does not exist yet.
  std::unique_ptr<Robot> robot(const std::string& name, int axes = 6) {
    if (!robots_.contains(name)) add_robot(name, axes);
    return std::make_unique<Robot>(*this, name, RobotModels{robots_.at(name)->model});
  }
  std::unique_ptr<Sensor> sensor(const std::string& name, bool interactive = true) {
    if (!sensors_.contains(name)) add_sensor(name, interactive);
    return std::make_unique<Sensor>(*this, name, "fake");
  }
  FakeRobotLink& robot_fake(const std::string& name) { return *robots_.at(name); }
  FakeSensorLink& sensor_fake(const std::string& name) { return *sensors_.at(name); }

  const std::string& process_name() const noexcept override { return process_; }
  std::string robot_name(const std::string& requested) const override { return requested; }
  RobotLink& robot_link(const std::string& name, const std::string& /*type*/) override { return *robots_.at(name); }
  SensorLink& sensor_link(const std::string& name, const std::string& /*type*/, bool& interactive) override {
    interactive = sensors_.at(name)->interactive;
    return *sensors_.at(name);
  }
  double servo_period() const noexcept override { return 0.002; }
  Tick tick() const noexcept override { return time.tick; }
  /// Advances by half a tick per tick.
  double wall_seconds() const noexcept override { return 2 * static_cast<double>(time.tick) * servo_period(); }
  void sleep_until(Tick until) override {
    log.add({Action::sleep, "", until});
    time.reach(until);
  }
  double operator_speed() const noexcept override { return speed; }
  OperatorRequest operator_request() noexcept override {
    log.add({Action::ask_operator, ""});
    return asked_ < requests.size() ? requests[asked_++] : OperatorRequest::none;
  }
  bool take_trigger() noexcept override {
    if (triggers == 0) return false;
    --triggers;
    return true;
  }
  StepObserver* observer() noexcept override { return step_observer; }

  FakeTime time;
  CallLog log;
  double speed = 1;                       ///< that the operator wants
  std::vector<OperatorRequest> requests;  ///< one for each query of an instruction; then none
  int triggers = 0;
  StepObserver* step_observer = nullptr;

 private:
  std::string process_;
  std::map<std::string, std::unique_ptr<FakeRobotLink>> robots_;
  std::map<std::string, std::unique_ptr<FakeSensorLink>> sensors_;
  std::size_t asked_ = 0;
};

}  // namespace mrroc::fakes
