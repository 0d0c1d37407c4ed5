#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "drivers/mujoco/mujoco_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "fixture.hpp"
#include "mrroc/robots/serial_parallel.hpp"
#include "sim/simulation.hpp"

namespace mrroc {

inline constexpr double kPeriod = 0.002;  // s

inline config::Deployment one_machine() {
  config::Deployment deployment;
  deployment.file = std::filesystem::path(MRROC_SOURCE_DIR) / "tests/robots/serial_parallel/test.toml";
  deployment.sim.emplace();
  deployment.sim->scene = deployment.file.parent_path() / "scene.xml";
  config::RobotEntry robot;
  robot.name = "machine";
  robot.type = "serial_parallel";
  robot.driver.world = true;
  robot.base.translation().z() = 0.6;
  deployment.robots.push_back(robot);
  return deployment;
}

/// The machine in the simulated world with its whole EDP core: effector, servo, driver.
class SerialParallelWorld : public testing::Test {
 protected:
  SerialParallelWorld() : simulation(one_machine(), *memory) {
    simulation.publish_initial();
    effector.enable(true);
    tick();
  }

  void tick() {
    servo.tick(now);
    edp::Reply reply;
    while (effector.poll(reply)) last = reply.state;
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) {
      simulation.step(++now);
      tick();
      worst_residual = std::max(worst_residual, residual());
      ASSERT_EQ(contacts(), 0) << "tick " << now;
    }
  }
  /// A joint move of `ticks` and the second after it.
  void go(const JointVector& joints, std::uint16_t ticks) {
    edp::Reply refusal;
    RobotCommand command;
    command.kind = CommandKind::joint;
    command.joints = joints;
    command.motion_steps = ticks;
    command.reply_step = ticks;
    ASSERT_FALSE(effector.accept(command, ++number, refusal)) << refusal.state.error.detail.view();
    run(ticks + 500U);
    ASSERT_TRUE(servo.snapshot().enabled()) << static_cast<int>(servo.snapshot().fault.code);
  }
  /// Largest distance between the two ends of a loop, m.
  double residual() {
    const mjData& data = simulation.world().data();
    return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(data.efc_pos).cwiseAbs().maxCoeff();
  }
  /// Contacts of the machine's moving parts.
  int contacts() {
    const mjModel& model = simulation.world().model();
    const mjData& data = simulation.world().data();
    int count = 0;
    for (int i = 0; i < data.ncon; ++i) {
      for (const int geom : {data.contact[i].geom1, data.contact[i].geom2}) {
        count += model.body_weldid[model.geom_bodyid[geom]] != 0 ? 1 : 0;
      }
    }
    return count;
  }
  Pose tool_in_world() {
    const mjModel& model = simulation.world().model();
    const mjData& data = simulation.world().data();
    const int site = mj_name2id(&model, mjOBJ_SITE, "machine/tool");
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Map<const Eigen::Vector3d>(data.site_xpos + 3 * site);
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.site_xmat + 9 * site);
    return pose;
  }
  /// The pose of the simulated tool relative to that of the model at the measured joints.
  double model_error() {
    Pose expected = machine().flange(servo.snapshot().joints) * machine().default_tool();
    expected.translation().z() += 0.6;
    return pose_difference(tool_in_world(), expected);
  }
  JointVector down_at(double x, double y, double z) const {
    JointVector joints;
    EXPECT_EQ(machine().inverse(SerialParallel::tool_down(x, y, z) * machine().default_tool().inverse(),
                                machine().parameters().home, joints),
              ErrorCode::none);
    return joints;
  }

  std::unique_ptr<world::WorldMemory> memory = std::make_unique<world::WorldMemory>();
  sim::Simulation simulation;
  edp::MujocoHardware hardware{machine(), *memory, 0, edp::MujocoHardware::Timing::lockstep};
  edp::ServoChannel hand_over;
  edp::ModelSet models{machine()};
  edp::Servo servo{models, hardware, kPeriod, hand_over};
  edp::Effector effector{models, kPeriod, hand_over};
  std::uint64_t number = 0;
  Tick now = 0;
  RobotState last;
  double worst_residual = 0;
};

}  // namespace mrroc
