#include <gtest/gtest.h>

#include "config/message_of.hpp"
#include "gripper_fixture.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/common/changed_file.hpp"

namespace mrroc::parameter_file_test {
namespace {

std::string error_with(const std::string& from, const std::string& to) {
  const task_test::ScratchFolder scratch;
  const auto file = scratch.write("g.toml", changed_file(gripper_source("two_finger_gripper.toml"), from, to));
  return config::message_of(scratch.path(), [&] { load_two_finger_gripper(file); });
}

TEST(GripperFile, ErrorsNameTheirKey) {
  EXPECT_EQ(error_with("reach = 0.125", "reach = 0.13"), "");
  EXPECT_NE(error_with("reach = 0.125", "reach = -0.1").find("geometry.reach: -0.1 is out of range"), std::string::npos)
      << error_with("reach = 0.125", "reach = -0.1");
  EXPECT_NE(error_with("reach = 0.125", "reech = 0.125").find("geometry.reach: missing"), std::string::npos);
  EXPECT_NE(error_with("[geometry]", "[geometry]\nwidth = 1").find("geometry.width: unknown key"), std::string::npos);
  EXPECT_NE(error_with("opening_at_zero = 0.074", "opening_at_zero = nan").find("geometry.opening_at_zero"),
            std::string::npos);
}

TEST(GripperFile, RefusesATransmissionThatReversesWithinTheMotorsLimits) {
  EXPECT_NE(
      error_with("opening_curvature = -2.8313e-09", "opening_curvature = 0.0").find("geometry.opening_curvature: 0"),
      std::string::npos);
  const std::string message = error_with("opening_slope = -1.451910074e-05", "opening_slope = -1e-05");
  EXPECT_NE(message.find("geometry.opening_curvature: the transmission has its dead centre at -1765.97"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("expected one outside -2000"), std::string::npos) << message;
}

TEST(GripperFile, AcceptsOtherSidesAndSignsOfTheParabola) {
  const task_test::ScratchFolder scratch;
  // the same parabola mirrored: the motor turns in the opposite direction
  std::string text = changed_file(gripper_source("two_finger_gripper.toml"), "opening_slope = -", "opening_slope = ");
  const auto set = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  set("motor_min = -2000.0", "motor_min = -5000.0");
  set("motor_max = 5000.0", "motor_max = 2000.0");
  set("motor_synchro = -1700.0", "motor_synchro = 1700.0");
  const RobotModels mirrored = load_two_finger_gripper(scratch.write("g.toml", text));
  for (const double opening : {0.053, 0.07, 0.091}) {
    JointVector motors;
    ASSERT_EQ(mirrored.front()->joints_to_motors(one(opening), motors), ErrorCode::none);
    EXPECT_NEAR(motors[0], -motor_of(opening), 1e-9);
    EXPECT_NEAR(mirrored.front()->transmission(one(opening))(0, 0), -gripper_model()->transmission(one(opening))(0, 0),
                1e-6);
  }
}

TEST(GripperFile, InstalledFileLoads) {
  const RobotModels models = load_two_finger_gripper();
  ASSERT_EQ(models.size(), 1U);
  EXPECT_EQ(models.front()->parameters().type, "two_finger_gripper");
  EXPECT_EQ(models.front()->parameters().axes.front().name, "opening");
}

}  // namespace
}  // namespace mrroc::parameter_file_test
