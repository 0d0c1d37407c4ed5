// Commands of a Move at the operator's speed.
#include <gtest/gtest.h>

#include <cmath>

#include "language/fakes.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/impedance.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/lead_through.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/move.hpp"

namespace mrroc::speed_override_test {
namespace {

using fakes::FakeTask;

/// Constant velocity 0.1 /s; notes what the generator sees.
class Uniform : public Generator {
 public:
  explicit Uniform(Robot& robot, bool scales = true, CommandKind kind = CommandKind::joint)
      : Generator("Uniform"), robot_(&robot), scales_(scales), kind_(kind) {}
  bool scales_with_speed() const override { return scales_; }
  void next_state() override {
    seen.push_back(robot_->state());
    RobotCommand& command = robot_->command();
    command.kind = kind_;
    const Eigen::Index axes = robot_->state().desired_joints.size();
    command.joint_velocity = JointVector::Constant(axes, 0.1);
    command.twist.setConstant(0.1);
    if (kind_ != CommandKind::joint) return;
    command.joint_acceleration = JointVector::Zero(axes);
    command.joints = robot_->state().desired_joints + 0.1 * robot_->step_duration() * JointVector::Ones(axes);
    command.with_outputs = true;
  }
  std::vector<RobotState> seen;

 private:
  Robot* robot_;
  bool scales_;
  CommandKind kind_;
};

/// Records the commands of every step.
struct Commands : StepObserver {
  void on_step(const StepRecord& record) noexcept override {
    if (!record.commands.empty()) commands.push_back(record.commands[0]);
  }
  std::vector<RobotCommand> commands;
};

struct Rig : FakeTask {
  Rig() { step_observer = &recorded; }
  std::vector<RobotCommand> run(Generator& generator, std::uint64_t steps) {
    recorded.commands.clear();
    Move({*arm}, {}, generator.until(ElapsedSteps{steps}));
    return recorded.commands;
  }
  Commands recorded;
  std::unique_ptr<Robot> arm = robot("arm");
};

TEST(SpeedOverride, FullSpeedAndMotionsThatDoNotScaleAreExecutedAsCommanded) {
  for (const bool scales : {true, false}) {
    Rig rig;
    rig.speed = scales ? 1 : 0.3;
    Uniform motion{*rig.arm, scales};
    const auto commands = rig.run(motion, 20);
    ASSERT_EQ(motion.seen.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_EQ(commands[i].motion_steps, 10);
      EXPECT_EQ(commands[i].joint_velocity[0], 0.1);
      EXPECT_EQ(commands[i].joints[0], motion.seen[i].desired_joints[0] + 0.1 * rig.arm->step_duration() * 1.0);
    }
  }
}

TEST(SpeedOverride, GeneratorSeesItsOwnStates) {
  Rig rig;
  rig.speed = 0.37;
  Uniform motion{*rig.arm};
  rig.run(motion, 200);
  ASSERT_GT(motion.seen.size(), 60u);
  EXPECT_LT(motion.seen.size(), 80u);
  for (std::size_t i = 1; i < motion.seen.size(); ++i) {
    EXPECT_NEAR(motion.seen[i].desired_velocity[0], 0.1, 1e-12);
    EXPECT_NEAR(motion.seen[i].desired_joints[0], 0.002 * static_cast<double>(i), 1e-12);
  }
}

TEST(SpeedOverride, ConstantSpeedScalesVelocitiesAndKeepsTheLengthOfTheSteps) {
  Rig rig;
  rig.speed = 0.3;
  Uniform motion{*rig.arm};
  const auto commands = rig.run(motion, 200);
  for (std::size_t i = 8; i < commands.size(); ++i) {  // after the start from rest
    EXPECT_NEAR(commands[i].joint_velocity[0], 0.03, 1e-9);
    EXPECT_GE(commands[i].motion_steps, 5);
    EXPECT_LE(commands[i].motion_steps, 16);
    EXPECT_EQ(commands[i].reply_step + 2, commands[i].motion_steps) << "the same time for the next command";
  }
  const auto first = [](const RobotCommand& command) { return command.with_outputs; };
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(commands.begin(), commands.end(), first)), motion.seen.size());
}

TEST(SpeedOverride, ChangesGraduallyInMotion) {
  Rig rig;
  Uniform motion{*rig.arm};
  rig.run(motion, 10);
  rig.speed = 0.2;
  Uniform next{*rig.arm};
  const auto commands = rig.run(next, 300);
  for (std::size_t i = 1; i < commands.size(); ++i) {
    const double change = commands[i].joint_velocity[0] - commands[i - 1].joint_velocity[0];
    EXPECT_LE(change, 1e-12);
    EXPECT_GE(change, -0.1 * 1 * 0.002 * commands[i].motion_steps - 1e-12);
  }
  EXPECT_NEAR(commands.back().joint_velocity[0], 0.02, 1e-12);
}

TEST(SpeedOverride, VelocitiesAreScaledAndForceMotionsAreNot) {
  Rig rig;
  rig.speed = 0.5;
  Uniform velocity{*rig.arm, true, CommandKind::joint_velocity}, force{*rig.arm, true, CommandKind::force};
  for (const RobotCommand& command : rig.run(velocity, 20)) EXPECT_NEAR(command.joint_velocity[0], 0.05, 1e-12);
  for (const RobotCommand& command : rig.run(force, 20)) {
    EXPECT_EQ(command.twist[0], 0.1);
    EXPECT_EQ(command.motion_steps, 10);
  }
}

TEST(SpeedOverride, HoldingTimesAreNotScaled) {
  Rig rig;
  rig.speed = 0.1;
  const Outcome outcome = Move({*rig.arm}, {}, Hold{*rig.arm, 1.0});
  EXPECT_NEAR(outcome.duration, 1.0, 0.03);
}

TEST(SpeedOverride, TogetherScalesIfAllItsPartsDo) {
  Rig rig;
  Uniform yes{*rig.arm}, no{*rig.arm, false};
  EXPECT_TRUE((Together{yes, Hold{*rig.arm, 1}}.scales_with_speed()));
  EXPECT_FALSE((Together{yes, no}.scales_with_speed()));
}

}  // namespace
}  // namespace mrroc::speed_override_test
