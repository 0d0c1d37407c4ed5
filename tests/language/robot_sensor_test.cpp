#include <gtest/gtest.h>

#include <cmath>

#include "language/fakes.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::robot_sensor_test {
namespace {

using fakes::FakeTask;

ErrorCode macrostep_code(Robot& robot, std::uint16_t motion_steps, std::uint16_t reply_step) {
  try {
    robot.set_macrostep(motion_steps, reply_step);
  } catch (const NonFatalError& error) {
    return error.code();
  }
  return ErrorCode::none;
}

TEST(Robot, AcceptsMacrostepsThatContainTheirReply) {
  FakeTask task;
  const auto arm = task.robot("arm");
  EXPECT_EQ(arm->motion_steps(), 10);
  EXPECT_EQ(arm->reply_step(), 8);
  EXPECT_DOUBLE_EQ(arm->step_duration(), 0.020);
  EXPECT_EQ(macrostep_code(*arm, 1, 1), ErrorCode::none);
  EXPECT_EQ(macrostep_code(*arm, 1, 2), ErrorCode::none);
  EXPECT_EQ(macrostep_code(*arm, kMaxMotionSteps, kMaxMotionSteps + 1), ErrorCode::none);
  EXPECT_EQ(macrostep_code(*arm, 0, 1), ErrorCode::invalid_motion_steps);
  EXPECT_EQ(macrostep_code(*arm, kMaxMotionSteps + 1, 1), ErrorCode::invalid_motion_steps);
  EXPECT_EQ(macrostep_code(*arm, 65535, 1), ErrorCode::invalid_motion_steps);
  EXPECT_EQ(macrostep_code(*arm, 10, 0), ErrorCode::invalid_reply_step);
  EXPECT_EQ(macrostep_code(*arm, 10, 12), ErrorCode::invalid_reply_step);
  EXPECT_EQ(arm->motion_steps(), kMaxMotionSteps);  // a refused value changes nothing
}

TEST(Robot, EveryCommandStartsAsAPlainHold) {
  FakeTask task;
  const auto arm = task.robot("arm");
  arm->set_macrostep(20, 5);
  arm->command().relative = true;
  arm->command().joints = JointVector::Ones(6);
  arm->command().joint_velocity = JointVector::Ones(6);
  arm->command().joint_acceleration = JointVector::Ones(6);
  arm->command().start_tick = 7;
  arm->command().pose.translation().x() = 1;
  arm->command().twist.setOnes();
  arm->reset_command(CommandKind::hold);
  const RobotCommand& command = arm->command();
  EXPECT_EQ(command.kind, CommandKind::hold);
  EXPECT_FALSE(command.relative);
  EXPECT_EQ(command.motion_steps, 20);
  EXPECT_EQ(command.reply_step, 5);
  EXPECT_EQ(command.start_tick, 0u);
  EXPECT_EQ(command.joints.size() + command.joint_velocity.size() + command.joint_acceleration.size(), 0);
  EXPECT_TRUE(command.pose.matrix().isIdentity());
  EXPECT_TRUE(command.twist.isZero());
}

TEST(Robot, HasNoKnownStateBeforeItsFirstInstruction) {
  FakeTask task;
  const auto arm = task.robot("arm");
  EXPECT_THROW(arm->known_state(), NonFatalError);
  Wait({*arm}, {}, ElapsedSteps{0});
  EXPECT_EQ(&arm->known_state(), &arm->state());
}

TEST(Sensor, IsReadAtItsPeriod) {
  FakeTask task;
  const auto gate = task.sensor("gate");
  EXPECT_EQ(gate->period(), 1u);
  EXPECT_THROW(gate->set_period(0), NonFatalError);
  gate->set_period(3);
  EXPECT_TRUE(gate->due(0));
  EXPECT_FALSE(gate->due(1));
  EXPECT_TRUE(gate->due(6));
  Wait({}, {*gate}, ElapsedSteps{7});
  EXPECT_EQ(gate->reading().sequence, 3u);  // steps 0, 3, 6
  EXPECT_EQ(gate->value(0), 2.0);
  EXPECT_TRUE(std::isnan(gate->value(1)));
}

TEST(Sensor, IsNotReadyWithoutAReading) {
  FakeTask task;
  const auto gate = task.sensor("gate", false);
  task.sensor_fake("gate").ready_from = 1;
  try {
    Wait({}, {*gate}, ElapsedSteps{0});
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_not_ready);
    EXPECT_EQ(error.origin().device, "gate");
  }
  EXPECT_EQ(Wait({}, {*gate}, ElapsedSteps{0}).steps, 0u);  // now it has one
}

TEST(Sensor, PolledSensorIsNeverAwaited) {
  FakeTask task;
  task.add_sensor("camera").is_polled = true;
  const auto arm = task.robot("arm");
  const auto camera = task.sensor("camera");
  EXPECT_EQ(camera->age(), std::numeric_limits<double>::infinity());
  task.sensor_fake("camera").late = 2;
  std::vector<bool> fresh;
  std::vector<double> values;
  Wait({*arm}, {*camera}, When{"five steps", [&] {
                                 fresh.push_back(camera->fresh());
                                 values.push_back(camera->value(0));
                                 return fresh.size() == 5;
                               }});
  EXPECT_EQ(fresh, (std::vector<bool>{false, false, true, true, true})) << "a reading that is not ready is a value";
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
  EXPECT_EQ(values[2], 0);
  EXPECT_EQ(values[4], 2);
  std::vector<Tick> asked;
  for (const fakes::Call& call : task.log.calls)
    if (call.action == fakes::Action::request) asked.push_back(call.tick);
  EXPECT_EQ(asked, (std::vector<Tick>{0, 0, 0})) << "at once, and one request at a time";
}

TEST(Sensor, HasTheAgeOfItsReading) {
  FakeTask task;
  const auto gate = task.sensor("gate");
  Wait({}, {*gate}, ElapsedSteps{0});
  EXPECT_TRUE(gate->fresh());
  EXPECT_EQ(gate->age(), 0);
  task.time.tick += 50;
  EXPECT_DOUBLE_EQ(gate->age(), 0.1);
}

TEST(Sensor, BiasesWhenInteractive) {
  FakeTask task;
  const auto wrist = task.sensor("wrist");
  const auto gate = task.sensor("gate", false);
  wrist->bias();
  EXPECT_EQ(task.log.calls, (std::vector<fakes::Call>{{.action = fakes::Action::bias, .device = "wrist"},
                                                      {.action = fakes::Action::collect, .device = "wrist"}}));
  EXPECT_EQ(wrist->reading().sequence, 1u);
  EXPECT_THROW(gate->bias(), NonFatalError);
  task.sensor_fake("wrist").errors[1] = {ErrorClass::hardware, ErrorCode::sensor_hardware, {}};
  EXPECT_THROW(wrist->bias(), HardwareError);
}

}  // namespace
}  // namespace mrroc::robot_sensor_test
