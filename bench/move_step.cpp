// The language's own cost of one step of Move: the time of a Move on links that answer at once, minus the time of a
// hand-written loop that makes the same calls of the links, the generator and the condition. Both are measured in turn,
// round by round, in processor time of this thread, so that other work of the machine does not count; the table shows
// medians over the rounds. Below it, the cost that a process adds: each step, encoded, in memory that outlives the
// process.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "language/fakes.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "process/record/shared_black_box.hpp"
#include "process/record/step_encoder.hpp"

namespace mrroc {
namespace {

constexpr std::uint64_t kSteps = 2000;
constexpr int kRounds = 401;
constexpr double kBar = 1e-6;   // s per step: 1 robot, 1 sensor, 1 condition
constexpr double kGoal = 5e-7;  // s per step

class EchoRobotLink : public RobotLink {
 public:
  explicit EchoRobotLink(int axes) {
    state_.joints = state_.joint_velocity = state_.motors = state_.current = JointVector::Zero(axes);
    state_.desired_joints = state_.desired_velocity = state_.desired_acceleration = JointVector::Zero(axes);
  }
  void send(const RobotCommand& command) override { command_ = command; }
  void receive(RobotState& state) override {
    state_.tick += command_.motion_steps;
    state_.desired_tick = state_.tick + 2;
    if (command_.kind == CommandKind::joint) {
      state_.desired_joints = command_.joints;
      state_.desired_velocity = command_.joint_velocity;
    }
    state = state_;
  }

 private:
  RobotCommand command_;
  RobotState state_;
};

class EchoSensorLink : public SensorLink {
 public:
  void request(const SensorRequest& request) override { reading_.tick = request.measure_at; }
  void receive(SensorReading& reading) override {
    ++reading_.sequence;
    reading = reading_;
  }
  bool latest(SensorReading& reading) override {
    receive(reading);
    return true;
  }

 private:
  SensorReading reading_;
};

class EchoTask : public Task {
 public:
  EchoTask(int robots, int sensors) : model(std::make_shared<fakes::FakeModel>(6)) {
    for (int i = 0; i < robots; ++i) robot_links.push_back(std::make_unique<EchoRobotLink>(6));
    for (int i = 0; i < sensors; ++i) sensor_links.push_back(std::make_unique<EchoSensorLink>());
  }
  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested; }
  RobotLink& robot_link(const std::string& name, const std::string&) override {
    return *robot_links.at(std::stoul(name));
  }
  SensorLink& sensor_link(const std::string& name, const std::string&, bool& interactive) override {
    interactive = name != "1";  // the second one is non-interactive
    return *sensor_links.at(std::stoul(name));
  }
  double servo_period() const noexcept override { return 0.002; }
  Tick tick() const noexcept override { return 0; }
  double wall_seconds() const noexcept override { return 0; }
  void sleep_until(Tick) override {}
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return step_observer; }

  StepObserver* step_observer = nullptr;
  std::shared_ptr<fakes::FakeModel> model;
  std::vector<std::unique_ptr<EchoRobotLink>> robot_links;
  std::vector<std::unique_ptr<EchoSensorLink>> sensor_links;

 private:
  std::string name_ = "bench";
};

/// Every robot continues at a constant joint velocity.
class Advance : public Generator {
 public:
  explicit Advance(std::vector<Robot*> robots) : Generator("advance"), robots_(std::move(robots)) {}
  void next_state() override {
    for (Robot* robot : robots_) {
      RobotCommand& command = robot->command();
      command.kind = CommandKind::joint;
      command.joints = robot->state().desired_joints + velocity_ * 1e-3;
      command.joint_velocity = velocity_;
    }
  }

 private:
  std::vector<Robot*> robots_;
  JointVector velocity_ = JointVector::Ones(6);
};

struct Bench {
  Bench(int robot_count, int sensor_count) : task(robot_count, sensor_count) {
    for (int i = 0; i < robot_count; ++i) {
      robots.push_back(std::make_unique<Robot>(task, std::to_string(i), RobotModels{task.model}));
      robot_list.push_back(robots.back().get());
    }
    for (int i = 0; i < sensor_count; ++i) {
      sensors.push_back(std::make_unique<Sensor>(task, std::to_string(i), "echo"));
      sensor_list.push_back(sensors.back().get());
    }
  }

  void move() {
    Advance generator(robot_list);
    Move(RobotList{robot_list}, SensorList{sensor_list}, generator.until(ElapsedSteps{kSteps}));
  }

  /// The calls that a Move makes, and nothing else.
  void by_hand() {
    Advance generator(robot_list);
    Generator& next = generator;  // virtual calls, as in Move
    const std::shared_ptr<Condition> condition = std::make_shared<ElapsedSteps>(kSteps);
    condition->start();
    for (Robot* robot : robot_list) robot->reset_command(CommandKind::query);
    exchange();
    while (!condition->evaluate() && !next.terminal_condition()) {
      next.next_state();
      exchange();
    }
  }

  void exchange() {
    for (Sensor* sensor : sensor_list) sensor->initiate_reading(0);
    for (Robot* robot : robot_list) robot->send();
    for (Robot* robot : robot_list) robot->receive();
    for (Sensor* sensor : sensor_list) sensor->collect_reading();
  }

  EchoTask task;
  std::vector<std::unique_ptr<Robot>> robots;
  std::vector<std::unique_ptr<Sensor>> sensors;
  std::vector<Robot*> robot_list;
  std::vector<Sensor*> sensor_list;
};

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Function>
double seconds_per_step(Function&& function) {
  const double begin = processor_seconds();
  function();
  return (processor_seconds() - begin) / static_cast<double>(kSteps);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
  return values[kRounds / 2];
}

/// As process::StepReporter does without a recording.
class LastSteps : public StepObserver {
 public:
  void on_step(const StepRecord& record) noexcept override {
    process::encode_step(step_, deployment_, "bench", record);
    memory_.record(record.tick, step_);
  }

 private:
  config::Deployment deployment_;
  process::EncodedStep step_;
  process::SharedBlackBox memory_ = process::SharedBlackBox::create();
};

/// Cost of encoding each step, compared with a Move without it.
void measure_last_steps(int robots, int sensors) {
  Bench bench(robots, sensors);
  const auto last_steps = std::make_unique<LastSteps>();
  std::vector<double> without, with;
  for (int round = 0; round < kRounds; ++round) {
    bench.task.step_observer = nullptr;
    without.push_back(seconds_per_step([&] { bench.move(); }));
    bench.task.step_observer = last_steps.get();
    with.push_back(seconds_per_step([&] { bench.move(); }));
  }
  std::printf("encoding each step, with %d robots, %d sensors: %.2f us\n", robots, sensors,
              1e6 * (median(with) - median(without)));
}

/// Prints one line of the table; returns the language's own cost, s per step.
double measure(int robots, int sensors) {
  Bench bench(robots, sensors);
  std::vector<double> moves, hands, costs;
  for (int round = 0; round < kRounds; ++round) {
    hands.push_back(seconds_per_step([&] { bench.by_hand(); }));
    moves.push_back(seconds_per_step([&] { bench.move(); }));
    costs.push_back(moves.back() - hands.back());
  }
  const double own = median(costs);
  std::printf("%7d %8d %12.0f %12.0f %8.2f %10.3f\n", robots, sensors, 1e9 * median(moves), 1e9 * median(hands),
              median(moves) / median(hands), 1e6 * own);
  return own;
}

}  // namespace
}  // namespace mrroc

int main() {
  std::printf(" robots  sensors  Move, ns/step  by hand, ns  ratio  own cost, us\n");
  const double own = mrroc::measure(1, 1);
  for (const int robots : {1, 2, 5}) mrroc::measure(robots, 2);
  for (const int robots : {1, 2}) mrroc::measure_last_steps(robots, 1);
  const bool pass = own < mrroc::kBar;
  std::printf("own cost with 1 robot, 1 sensor, 1 condition: %.3f us; bar %.1f us: %s; goal %.1f us: %s\n", 1e6 * own,
              1e6 * mrroc::kBar, pass ? "pass" : "FAIL", 1e6 * mrroc::kGoal, own < mrroc::kGoal ? "pass" : "FAIL");
  return pass ? 0 : 1;
}
