#include <gtest/gtest.h>

#include "allocations.hpp"
#include "drivers/loopback/regulated_loopback.hpp"
#include "drivers/mujoco/mujoco_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "robots/arm/arm_fixture.hpp"

namespace mrroc::edp {
namespace {

constexpr double kPeriod = 0.002;

/// Ticks of a servo with `hardware`, whose arm moves its axes.
std::uint64_t allocations_of_ticks(const RobotModel& model, Hardware& hardware) {
  ModelSet models{model};
  ServoChannel channel;
  Servo servo(models, hardware, kPeriod, channel);
  Effector effector(models, kPeriod, channel);
  effector.enable(true);
  Reply reply;
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.joints = model.parameters().home;
  command.joints[0] -= 0.005;
  command.joint_velocity = JointVector::Zero(6);
  command.motion_steps = command.reply_step = 100;
  for (Tick tick = 0; tick < 3; ++tick) servo.tick(tick);
  const std::uint64_t before = test::allocations();
  EXPECT_FALSE(effector.accept(command, 1, reply)) << reply.state.error.detail.view();
  for (Tick tick = 3; tick < 200; ++tick) {
    servo.tick(tick);
    effector.poll(reply);
  }
  const std::uint64_t count = test::allocations() - before;
  EXPECT_NEAR(servo.snapshot().desired.position[0], command.joints[0], 1e-12);
  return count;
}

TEST(ArmAllocation, ServoTicksAllocateNothing) {
  const RobotModels models = load_arm(kBenchArm);
  RegulatedLoopback loopback(*models.front(), kPeriod);
  EXPECT_EQ(allocations_of_ticks(*models.front(), loopback), 0U);
}

TEST(ArmAllocation, SetPointsForTheWorldAllocateNothing) {
  const RobotModels models = load_arm(kBenchArm);
  const auto memory = std::make_unique<world::WorldMemory>();
  MujocoHardware hardware(*models.front(), *memory, 0, MujocoHardware::Timing::newest);
  world::JointMeasurement measurement{};
  for (std::size_t i = 0; i < 6; ++i)
    measurement.position[i] = models.front()->parameters().home[static_cast<Eigen::Index>(i)];
  memory->measurements[0].store(measurement);
  HardwareInput input;
  hardware.enable(true);
  hardware.read(1, input);
  const JointVector set_point = input.motors.array() + 0.01, speed = JointVector::Constant(6, 0.5);
  const std::uint64_t before = test::allocations();
  hardware.set_points(set_point, speed);
  hardware.write(1, JointVector::Zero(6));
  hardware.read(2, input);
  EXPECT_EQ(test::allocations() - before, 0U);
  world::JointDrive drive{};
  ASSERT_TRUE(memory->drives[0].load(drive));
  EXPECT_EQ(drive.kind, world::JointDrive::Kind::position);
  EXPECT_EQ(drive.velocity[3], 0.5);
  EXPECT_NEAR(drive.position[3], measurement.position[3] + 0.01, 1e-5);
}

}  // namespace
}  // namespace mrroc::edp
