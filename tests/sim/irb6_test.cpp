// Two IRb-6 in one world, each with its whole EDP core: effector, servo, driver.
#include <gtest/gtest.h>

#include <bit>
#include <memory>

#include "drivers/mujoco/mujoco_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/simulation.hpp"
#include "worlds.hpp"

namespace mrroc::sim::irb6_test {
namespace {

constexpr double kPeriod = 0.002;

config::Deployment two_irb6() {
  config::Deployment deployment;
  deployment.file = kData / "test.toml";
  deployment.sim.emplace();
  deployment.sim->scene = kData / "scene.xml";
  for (const auto& [name, base] : {std::pair{"left", at(0, 0, 0.7)}, {"right", at(2.4, 0, 0.7, 3.1)}}) {
    config::RobotEntry robot;
    robot.name = name;
    robot.type = "irb6";
    robot.driver.world = true;
    robot.base = base;
    deployment.robots.push_back(robot);
  }
  config::SensorEntry wrist;
  wrist.name = "wrist";
  wrist.type = "force_torque";
  wrist.robot = "left";
  deployment.sensors.push_back(wrist);
  return deployment;
}

/// One robot's EDP core on slot `slot`.
struct Edp {
  Edp(world::WorldMemory& memory, std::size_t slot)
      : model(load_irb6().front()), hardware(*model, memory, slot, edp::MujocoHardware::Timing::lockstep) {}

  void tick(Tick now) {
    servo.tick(now);
    edp::Reply reply;
    while (effector.poll(reply)) last = reply.state;
  }
  bool go(const JointVector& joints) {
    edp::Reply refusal;
    RobotCommand command;
    command.kind = CommandKind::joint;
    command.joints = joints;
    command.motion_steps = 500;
    command.reply_step = 500;
    const bool refused = effector.accept(command, ++number, refusal);
    EXPECT_FALSE(refused) << refusal.state.error.detail.view();
    return !refused;
  }

  std::shared_ptr<const RobotModel> model;
  edp::MujocoHardware hardware;
  edp::ServoChannel hand_over;
  edp::ModelSet models{*model};
  edp::Servo servo{models, hardware, kPeriod, hand_over};
  edp::Effector effector{models, kPeriod, hand_over};
  std::uint64_t number = 0;
  RobotState last;
};

class TwoIrb6 : public testing::Test {
 protected:
  TwoIrb6() : simulation(two_irb6(), *memory) {
    simulation.publish_initial();
    for (Edp* edp : {&left, &right}) {
      edp->effector.enable(true);
      edp->tick(0);
    }
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) {
      simulation.step(++now);
      left.tick(now);
      right.tick(now);
    }
  }
  RawReading wrist() const {
    RawReading reading;
    EXPECT_TRUE(memory->readings[0].load(reading));
    return reading;
  }

  std::unique_ptr<world::WorldMemory> memory = std::make_unique<world::WorldMemory>();
  Simulation simulation;
  Edp left{*memory, 0}, right{*memory, 1};
  Tick now = 0;
};

int contacts_of_robots(const World& world) {
  int contacts = 0;
  for (int i = 0; i < world.data().ncon; ++i) {
    for (const int geom : {world.data().contact[i].geom1, world.data().contact[i].geom2}) {
      const std::string body = mj_id2name(&world.model(), mjOBJ_BODY, world.model().geom_bodyid[geom]);
      if (body.starts_with("left") || body.starts_with("right")) ++contacts;
    }
  }
  return contacts;
}

TEST_F(TwoIrb6, StandAtHomeWithoutSelfContactAndMeasureTheToolsWeight) {
  run(5);
  EXPECT_EQ(contacts_of_robots(simulation.world()), 0);
  const RawReading reading = wrist();
  ASSERT_EQ(reading.count, 6U);
  const Eigen::Vector3d force(reading.values[0], reading.values[1], reading.values[2]);
  EXPECT_NEAR(force.norm(), 1.1 * 9.81, 1.0);
}

TEST_F(TwoIrb6, RegulatorsHoldThemAgainstGravityAndReachTheirTargets) {
  run(500);
  const JointVector home = left.model->parameters().home;
  for (Edp* edp : {&left, &right}) {
    ASSERT_TRUE(edp->servo.snapshot().enabled()) << static_cast<int>(edp->servo.snapshot().fault.code);
    EXPECT_LT((edp->servo.snapshot().joints - home).cwiseAbs().maxCoeff(), 2e-3) << "after a second at home";
  }
  JointVector target = home;
  target[0] += 0.12;
  target[1] += 0.05;
  target[2] -= 0.06;
  target[3] += 0.1;
  ASSERT_TRUE(left.go(target));
  ASSERT_TRUE(right.go(target));
  run(1000);
  for (Edp* edp : {&left, &right}) {
    ASSERT_TRUE(edp->servo.snapshot().enabled()) << static_cast<int>(edp->servo.snapshot().fault.code);
    EXPECT_LT((edp->servo.snapshot().joints - target).cwiseAbs().maxCoeff(), 2e-3);
    EXPECT_EQ(edp->last.error.error_class, ErrorClass::none);
  }
  // the same motion from bases rotated against each other: gravity acts equally, and so do the arms
  EXPECT_LT((left.servo.snapshot().joints - right.servo.snapshot().joints).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(Eigen::Vector3d(wrist().values[0], wrist().values[1], wrist().values[2]).norm(), 1.1 * 9.81, 0.1);
}

TEST_F(TwoIrb6, ClosedLoopsAreEqualBitForBit) {
  const auto hash_of_run = [] {
    auto own_memory = std::make_unique<world::WorldMemory>();
    Simulation own(two_irb6(), *own_memory);
    own.publish_initial();
    Edp arm(*own_memory, 0);
    arm.effector.enable(true);
    arm.tick(0);
    std::uint64_t hash = 0;
    for (Tick k = 1; k <= 1500; ++k) {
      own.step(k);
      arm.tick(k);
      if (k == 200) {
        JointVector target = arm.model->parameters().home;
        target[0] += 0.1;
        EXPECT_TRUE(arm.go(target));
      }
      for (int i = 0; i < own.world().model().nq; ++i) {
        hash = hash * 31 + std::bit_cast<std::uint64_t>(own.world().data().qpos[i]);
      }
    }
    return hash;
  };
  EXPECT_EQ(hash_of_run(), hash_of_run());
}

// the measured position at every tick: the servo's lag is along the line, not across it
TEST_F(TwoIrb6, TaskSpaceLineIsStraightToATenthOfAMillimetre) {
  const ToolKinematics kinematics(*left.model);
  const Pose home = kinematics.direct(left.model->parameters().home);
  run(500);
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, 0.15, 0), {0, -0.3, 0}, {0, 0.15, 0.1}, {-0.05, 0.1, 0}}) {
    RobotState state;
    ASSERT_TRUE(left.effector.peek(state));
    const Eigen::Vector3d from = state.desired_pose.translation(), direction = way.normalized();
    RobotCommand command;
    command.kind = CommandKind::pose;
    command.interpolation = Interpolation::task;
    command.pose = home;
    command.pose.translation() = from + way;
    // the middle of the path at 50 mm/s: a quintic's largest velocity is 15/8 of its mean
    command.motion_steps = static_cast<std::uint16_t>(std::ceil(way.norm() * 15 / 8 / 0.05 / kPeriod));
    command.reply_step = command.motion_steps;
    edp::Reply refusal;
    ASSERT_FALSE(left.effector.accept(command, ++left.number, refusal)) << refusal.state.error.detail.view();
    double across = 0, turned = 0;
    for (int k = 0; k < command.motion_steps + 250; ++k) {
      run(1);
      const Pose tool = kinematics.direct(left.servo.snapshot().joints);
      const Eigen::Vector3d gone = tool.translation() - from;
      across = std::max(across, (gone - gone.dot(direction) * direction).norm());
      turned = std::max(turned, Eigen::AngleAxisd(home.linear().transpose() * tool.linear()).angle());
    }
    std::printf("%.0f mm: %.3f mm beside the line, %.2f mrad turned\n", 1000 * way.norm(), 1000 * across,
                1000 * turned);
    EXPECT_LT(across, 1e-4);
    EXPECT_LT((kinematics.direct(left.servo.snapshot().joints).translation() - from - way).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace mrroc::sim::irb6_test
