#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/mujoco/mujoco_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "mrroc/robots/irb6.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/task.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/simulation.hpp"

namespace mrroc::test {

/// A task process around an IRb-6 in the simulated world, its base 0.7 m above the floor, without processes and
/// transport: the EDP core answers the robot's link, the world's raw readings are the sensors' values. Waiting for a
/// reply advances the world tick by tick.
class SimulatedCell : public Task, private RobotLink {
 public:
  /// Opens the force sensor of the arm's EDP (tests/generators/force_cell.hpp), whose hardware is slot `slot`.
  using Wrist = std::function<std::unique_ptr<edp::ForceSensor>(const config::Deployment& deployment, std::size_t slot,
                                                                const world::WorldMemory& world)>;

  /// `wrist`: the arm also has a sensor of type force_torque.
  explicit SimulatedCell(const std::string& scene, const std::vector<std::string>& sensors = {},
                         const Wrist& wrist = {})
      : deployment_(deployment(scene, sensors, wrist != nullptr)), simulation_(deployment_, *memory_) {
    for (std::size_t i = 0; i < sensors.size(); ++i) links_.push_back({*this, sensors[i], i});
    if (wrist) {
      wrist_ = wrist(deployment_, sensors.size(), *memory_);
      servo_.use_force_sensor(*wrist_, (edp::ForceLimits() << 65, 65, 130, 5, 5, 5).finished());
      effector_.use_force_sensor(wrist_->mount());
    }
    simulation_.publish_initial();
    effector_.enable(true);
    servo_.tick(0);
    run(50);
  }

  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string&) const override { return name_; }
  RobotLink& robot_link(const std::string&, const std::string&) override { return *this; }
  SensorLink& sensor_link(const std::string& name, const std::string&, bool& interactive) override {
    interactive = true;
    for (Readings& link : links_)
      if (link.name == name) return link;
    throw NonFatalError(ErrorCode::invalid_argument, "no sensor " + name);
  }
  double servo_period() const noexcept override { return kPeriod; }
  Tick tick() const noexcept override { return now_; }
  double wall_seconds() const noexcept override { return 0; }
  void sleep_until(Tick tick) override {
    while (now_ < tick) step();
  }
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return nullptr; }

  void run(Tick ticks) { sleep_until(now_ + ticks); }
  mjData& data() { return simulation_.world().data(); }
  int id(mjtObj kind, const char* name) { return mj_name2id(&simulation_.world().model(), kind, name); }
  /// Pose of a body in the arm's base frame.
  Pose body(const char* name) {
    const int number = id(mjOBJ_BODY, name);
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Map<Eigen::Vector3d>(data().xpos + 3 * number) - Eigen::Vector3d(0, 0, 0.7);
    pose.linear() = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data().xmat + 9 * number);
    return pose;
  }
  /// The measured tool, in the arm's base frame.
  Pose tool() const { return ToolKinematics(*model_).direct(servo_.snapshot().joints); }
  /// Wrench at the arm's force sensor, in its own axes.
  const Wrench& force() const { return servo_.snapshot().wrench; }

  static constexpr double kPeriod = 0.002;
  std::function<void()> on_tick;

 private:
  struct Readings : SensorLink {
    Readings(SimulatedCell& cell_, std::string name_, std::size_t slot_)
        : cell(&cell_), name(std::move(name_)), slot(slot_) {}
    void request(const SensorRequest&) override {}
    void receive(SensorReading& reading) override {
      RawReading raw;
      ASSERT_TRUE(cell->memory_->readings[slot].load(raw));
      reading = {};
      reading.sequence = ++sequence;
      reading.tick = raw.tick;
      reading.channel_count = raw.count;
      for (std::size_t i = 0; i < raw.count; ++i) reading.values[i] = raw.values[i];
    }
    bool latest(SensorReading& reading) override {
      receive(reading);
      return true;
    }
    SimulatedCell* cell;
    std::string name;
    std::size_t slot;
    std::uint64_t sequence = 0;
  };

  config::Deployment deployment(const std::string& scene, const std::vector<std::string>& sensors, bool wrist) const {
    config::Deployment deployment;
    deployment.sim.emplace();
    deployment.sim->scene = scratch_.write("scene.xml", scene);
    config::RobotEntry robot;
    robot.name = "arm";
    robot.type = "irb6";
    robot.driver.world = true;
    robot.base.translation().z() = 0.7;
    deployment.robots.push_back(robot);
    for (const std::string& name : sensors) {
      config::SensorEntry sensor;
      sensor.name = name;
      sensor.type = "raw";
      deployment.sensors.push_back(sensor);
    }
    if (wrist) {
      config::SensorEntry sensor;
      sensor.name = "wrist";
      sensor.type = "force_torque";
      sensor.robot = "arm";
      deployment.sensors.push_back(sensor);
    }
    return deployment;
  }
  void step() {
    simulation_.step(++now_);
    servo_.tick(now_);
    edp::Reply reply;
    while (effector_.poll(reply)) {
      answer_ = reply.state;
      answered_ = true;
    }
    if (on_tick) on_tick();
  }
  void send(const RobotCommand& command) override {
    edp::Reply reply;
    answered_ = effector_.accept(command, ++number_, reply);
    if (answered_) answer_ = reply.state;
  }
  void receive(RobotState& state) override {
    while (!answered_) step();
    state = answer_;
  }

  std::string name_ = "arm";
  task_test::ScratchFolder scratch_;
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
  config::Deployment deployment_;
  sim::Simulation simulation_;
  std::shared_ptr<const RobotModel> model_ = load_irb6().front();
  edp::MujocoHardware hardware_{*model_, *memory_, 0, edp::MujocoHardware::Timing::lockstep};
  edp::ServoChannel channel_;
  edp::ModelSet models_{*model_};
  edp::Servo servo_{models_, hardware_, kPeriod, channel_};
  edp::Effector effector_{models_, kPeriod, channel_};
  std::unique_ptr<edp::ForceSensor> wrist_;
  std::vector<Readings> links_;
  std::uint64_t number_ = 0;
  Tick now_ = 0;
  RobotState answer_;
  bool answered_ = false;
};

/// A sensor with the values of the world's hardware.
class RawSensor : public Sensor {
 public:
  RawSensor(Task& task, const std::string& name) : Sensor(task, name, "raw") {}
};

}  // namespace mrroc::test
