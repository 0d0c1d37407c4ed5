#include "mrroc/sensors/force_torque.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/force_torque/made_sensor.hpp"
#include "sensors/played_task.hpp"

namespace mrroc::force_torque_test {
namespace {

const std::string kHeader =
    "# mrroc readings support_force_x support_force_y support_force_z "
    "support_torque_x support_torque_y support_torque_z\n";

/// A `ForceTorque` whose hardware replays `lines`.
class ForceTorqueTest : public ::testing::Test {
 protected:
  void play(const std::string& lines) {
    task_ = std::make_unique<vsp::PlayedTask>(aggregating_, "force_torque", kHeader + lines);
    wrist_ = std::make_unique<ForceTorque>(*task_, "wrist");
  }
  ForceTorque& wrist() { return *wrist_; }

 private:
  vsp::ForceTorqueSensor aggregating_ = vsp::made_sensor();
  std::unique_ptr<vsp::PlayedTask> task_;
  std::unique_ptr<ForceTorque> wrist_;
};

TEST_F(ForceTorqueTest, GivesTheWrenchOnTheTool) {
  play("0 -1 -2 -3 -4 -5 -6\n");
  EXPECT_TRUE(std::isnan(wrist().force().x()));
  Wait({}, {wrist()}, ForceAbove{wrist(), 0});
  EXPECT_EQ(wrist().wrench(), (Wrench{{1, 2, 3, 4, 5, 6}}));
  EXPECT_EQ(wrist().force(), (Eigen::Vector3d{1, 2, 3}));
  EXPECT_EQ(wrist().torque(), (Eigen::Vector3d{4, 5, 6}));
}

TEST_F(ForceTorqueTest, WaitEndsAtTheFirstReadingAboveTheForce) {
  play("0 0 0 5 0 0 0\n 47 6 0 8 0 0 0\n 51 6 0 8.1 0 0 0\n");
  const Outcome outcome = Wait({}, {wrist()}, ForceAbove{wrist(), 10});
  EXPECT_EQ(outcome.end_tick, 60U);  // readings at 0, 10, ... 60; exactly 10 N at 50 is not above
  EXPECT_EQ(outcome.steps, 6U);
  EXPECT_TRUE(outcome.by<ForceAbove>());
  EXPECT_TRUE(outcome.by("wrist force above 10 N"));
}

TEST_F(ForceTorqueTest, ForceAlongUsesOneDirectionOnly) {
  play("0 50 0 -20 0 0 0\n 20 0 0 4 0 0 0\n 30 0 0 6 0 0 0\n");
  // support along +z means that the environment pushes along -z, as on a tool that presses along +z
  const Outcome outcome = Wait({}, {wrist()}, ForceAlongAbove{wrist(), {0, 0, -2}, 5});
  EXPECT_EQ(outcome.end_tick, 30U);
}

TEST_F(ForceTorqueTest, ConfigurationsAreRefusedWithTheirReason) {
  play("0 -1 -2 -3 -4 -5 -6\n");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(wrist().configure(LowPassAt{-1}), NonFatalError);
  EXPECT_THROW(wrist().configure(LowPassAt{251}), NonFatalError) << "half the servo rate is 250 Hz";
  EXPECT_THROW(wrist().configure(LowPassAt{nan}), NonFatalError);
  EXPECT_THROW(wrist().configure(Carrying{-1, Eigen::Vector3d::Zero()}), NonFatalError);
  EXPECT_THROW(wrist().configure(Carrying{1, {nan, 0, 0}}), NonFatalError);
  EXPECT_THROW(wrist().configure(Carrying{1, Eigen::Vector3d::Zero()}), NonFatalError) << "it follows no robot";
  EXPECT_EQ(wrist().configuration(), 0U);
  wrist().configure(Carrying{0, Eigen::Vector3d::Zero()});
  wrist().configure(LowPassAt{5});
  EXPECT_EQ(wrist().configuration(), 2U);
  Wait({}, {wrist()}, ForceAbove{wrist(), 0});
  EXPECT_EQ(wrist().wrench(), (Wrench{{1, 2, 3, 4, 5, 6}}));
  EXPECT_EQ(wrist().reading().configuration, 2U);
}

TEST_F(ForceTorqueTest, ForceIsZeroAfterABias) {
  play("0 0 0 -5.89 0 0 0\n 40 0 0 6.11 0 0 0\n");
  wrist().bias();
  EXPECT_EQ(wrist().wrench(), Wrench::Zero());
  const Outcome outcome = Wait({}, {wrist()}, ForceAbove{wrist(), 11.9});
  EXPECT_EQ(outcome.end_tick, 40U);
  EXPECT_NEAR(wrist().force().z(), -12, 1e-12);
}

TEST_F(ForceTorqueTest, OverloadEndsTheWaitWithAnError) {
  play("0 0 0 5 0 0 0\n 20 0 0 500 0 0 0\n 30 0 0 5 0 0 0\n");
  try {
    Wait({}, {wrist()}, ForceAbove{wrist(), 1000});
    FAIL() << "no error";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_out_of_range);
    EXPECT_EQ(error.origin().device, "wrist");
    EXPECT_EQ(error.origin().tick, 20U);
  }
  wrist().task().sleep_until(30);  // the overload is over
  const Outcome outcome = Wait({}, {wrist()}, ForceAbove{wrist(), 4} && !ForceAbove{wrist(), 6});
  EXPECT_EQ(outcome.end_tick, 30U);
}

TEST_F(ForceTorqueTest, FailedTransducerIsAHardwareError) {
  play("0 0 0 nan 0 0 0\n");
  EXPECT_THROW(Wait({}, {wrist()}, ForceAbove{wrist(), 1}), HardwareError);
}

TEST_F(ForceTorqueTest, ConditionsRefuseInvalidForcesAndDirections) {
  play("0 0 0 0 0 0 0\n");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ForceAbove(wrist(), -1), NonFatalError);
  EXPECT_THROW(ForceAbove(wrist(), nan), NonFatalError);
  EXPECT_THROW(ForceAlongAbove(wrist(), {0, 0, 0}, 1), NonFatalError);
  EXPECT_THROW(ForceAlongAbove(wrist(), {0, nan, 0}, 1), NonFatalError);
  EXPECT_THROW(ForceAlongAbove(wrist(), {0, 0, 1}, nan), NonFatalError);
}

}  // namespace
}  // namespace mrroc::force_torque_test
