// The servo reports every error in a reply, which the task turns into an exception; it never prints.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "edp/force/force_rig.hpp"

namespace mrroc::edp::no_output_test {
namespace {

using Robot = ForceRig<Gantry>;

/// The output of the process while `act` ran.
std::string written_by(const std::function<void()>& act) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  act();
  const std::string out = testing::internal::GetCapturedStdout();
  return out + testing::internal::GetCapturedStderr();
}

// original's defect 22: the 500 Hz thread printed its errors, and some were reported nowhere else
TEST(NoOutput, EveryErrorOfTheServoIsInAReplyAndNoneIsPrinted) {
  const std::map<ErrorCode, std::function<void(Robot&)>> causes = {
      {ErrorCode::following_error, [](Robot& robot) { robot.hardware.jam = true; }},
      {ErrorCode::drive_fault, [](Robot& robot) { robot.hardware.fault = ErrorCode::drive_fault; }},
      {ErrorCode::not_enabled, [](Robot& robot) { robot.effector.enable(false); }},
      {ErrorCode::force_limit, [](Robot& robot) { robot.sensor.extra[1] = 1000; }},
      {ErrorCode::sensor_hardware, [](Robot& robot) { robot.sensor.error = ErrorCode::sensor_hardware; }}};
  for (const auto& [code, cause] : causes) {
    Robot robot;
    robot.sensor.wall = 10;
    RobotCommand command = force_command(0, 0.3);
    command.motion_steps = command.reply_step = 2000;
    if (code == ErrorCode::following_error) {
      command = joint_command((JointVector(4) << 1.5, 0, 0, 0).finished(), 2000, 2000);
    }
    const std::string written = written_by([&, &act = cause] {
      ASSERT_FALSE(robot.send(command)) << robot.answer.state.error.detail.view();
      robot.run(400);
      EXPECT_TRUE(robot.replies.empty());
      act(robot);
      robot.run(800);
    });
    EXPECT_EQ(written, "");
    ASSERT_EQ(robot.replies.size(), 1u) << static_cast<int>(code);
    EXPECT_EQ(robot.replies[0].state.error.code, code);
    EXPECT_NE(robot.replies[0].state.error.error_class, ErrorClass::none);
  }
}

}  // namespace
}  // namespace mrroc::edp::no_output_test
