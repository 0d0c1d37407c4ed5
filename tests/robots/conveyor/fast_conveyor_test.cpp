#include <gtest/gtest.h>

#include "mrroc/robots/conveyor.hpp"
#include "robots/common/one_robot_task.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"

namespace mrroc {
namespace {

std::shared_ptr<const RobotModel> slow_model() {
  static const RobotModels models = load_conveyor();
  return models.front();
}
const AxisParameters& slow() { return slow_model()->parameters().axes.front(); }

TEST(FastConveyor, GearIsAThirdAndTheMotorIsAsFastAsTheConveyors) {
  const double gear = conveyor_model()->transmission(one(0))(0, 0),
               slow_gear = slow_model()->transmission(one(0))(0, 0);
  EXPECT_EQ(gear, 750);
  EXPECT_EQ(gear, slow_gear / 3);
  EXPECT_EQ(belt().velocity_max, 0.15);
  EXPECT_NEAR(gear * belt().velocity_max, slow_gear * slow().velocity_max, 1e-9);
  EXPECT_NEAR(gear * belt().acceleration_max, slow_gear * slow().acceleration_max, 1e-9);
  EXPECT_NEAR(gear * belt().jerk_max, slow_gear * slow().jerk_max, 1e-9);
}

TEST(FastConveyor, DriveIsThatOfTheConveyor) {
  for (double AxisParameters::*number :
       {&AxisParameters::regulator_a, &AxisParameters::regulator_b0, &AxisParameters::regulator_b1,
        &AxisParameters::regulator_eps, &AxisParameters::regulator_output_max, &AxisParameters::regulator_current_gain,
        &AxisParameters::motor_synchro, &AxisParameters::current_max, &AxisParameters::following_error_max,
        &AxisParameters::torque_constant, &AxisParameters::rotor_inertia, &AxisParameters::viscous_friction})
    EXPECT_EQ(belt().*number, slow().*number);
  EXPECT_EQ(belt().encoder_increments, slow().encoder_increments);
}

TEST(FastConveyor, TaskUsesTheFileThatItsDeploymentNames) {
  OneRobotTask process("belt", "conveyor", conveyor_file("toml"));
  const Conveyor belt(process);
  EXPECT_EQ(belt.parameters().type, "conveyor");
  EXPECT_EQ(belt.parameters().axes.front().velocity_max, 0.15);
}

TEST(FastConveyor, IsRefusedForARobotOfAnotherType) {
  OneRobotTask process("belt", "irb6", conveyor_file("toml"));
  try {
    const Conveyor belt(process);
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
  }
}

}  // namespace
}  // namespace mrroc
