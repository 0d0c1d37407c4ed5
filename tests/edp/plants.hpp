#pragma once

#include <memory>
#include <string>

#include "drivers/mujoco/mujoco_hardware.hpp"
#include "rig.hpp"
#include "sim/simulation.hpp"

namespace mrroc::edp {

/// A robot's drives behind one of the drivers, with faults to inject.
class Plant {
 public:
  virtual ~Plant() = default;
  virtual Hardware& hardware() = 0;
  /// Advances the world to `tick`, before the servo's tick.
  virtual void advance(Tick tick) = 0;
  /// A fault that the drives report, while `on`.
  virtual void fail(bool on) = 0;
  /// An external force that the drives cannot resist moves the robot while `on`; afterwards the robot stays there.
  virtual void push(bool on) = 0;
};

/// Pushed: a shaft is turned at kSlip.
class LoopbackPlant final : public Plant {
 public:
  static constexpr double kSlip = 150;  // rad/s: twice the speed that the drive can compensate

  explicit LoopbackPlant(const RobotModel& model) : drives_(model, kPeriod) {
    drives_.rewire = [this](HardwareInput& input) { input.motors[1] += slip_; };
  }
  Hardware& hardware() override { return drives_; }
  void advance(Tick) override { slip_ += pushed_ ? kSlip * kPeriod : 0; }
  void fail(bool on) override { drives_.fault = on ? ErrorCode::drive_fault : ErrorCode::none; }
  void push(bool on) override { pushed_ = on; }

 private:
  FaultyHardware drives_;
  double slip_ = 0;
  bool pushed_ = false;
};

/// Pushed: a force of kForce lifts the tool. Failed: the world is silent.
class MujocoPlant final : public Plant {
 public:
  static constexpr double kForce = 1200;  // N: more than the arms' drives can hold at home

  MujocoPlant(const RobotModel& model, double height)
      : simulation_(deployment(model.parameters().type, height), *memory_),
        drives_(model, *memory_, 0, MujocoHardware::Timing::lockstep),
        tool_(mj_name2id(&simulation_.world().model(), mjOBJ_BODY, "arm/tool")) {
    simulation_.publish_initial();
  }
  Hardware& hardware() override { return drives_; }
  void advance(Tick tick) override {
    if (tick == 0) return;
    simulation_.world().data().xfrc_applied[6 * tool_ + 2] = pushed_ ? kForce : 0;
    simulation_.step(tick);
    if (!silent_) return;
    world::JointMeasurement measurement;
    memory_->measurements[0].load(measurement);
    measurement.tick -= 1;
    memory_->measurements[0].store(measurement);
  }
  void fail(bool on) override { silent_ = on; }
  void push(bool on) override { pushed_ = on; }

 private:
  static config::Deployment deployment(const std::string& type, double height) {
    config::Deployment deployment;
    deployment.file = std::filesystem::path(MRROC_SOURCE_DIR) / "tests/sim/data/test.toml";
    deployment.sim.emplace();
    deployment.sim->scene = std::filesystem::path(MRROC_SOURCE_DIR) / "tests/sim/data/scene.xml";
    config::RobotEntry robot;
    robot.name = "arm";
    robot.type = type;
    robot.driver.world = true;
    robot.base = Eigen::Translation3d(0, 0, height) * Pose::Identity();
    deployment.robots.push_back(robot);
    return deployment;
  }

  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
  sim::Simulation simulation_;
  MujocoHardware drives_;
  int tool_;
  bool silent_ = false, pushed_ = false;
};

}  // namespace mrroc::edp
