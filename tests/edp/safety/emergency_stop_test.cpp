#include <gtest/gtest.h>

#include "edp/servo/emergency_latch.hpp"
#include "safe_rig.hpp"

namespace mrroc::edp::emergency_stop_test {
namespace {

TEST(EmergencyStop, IsLatchedUntilItsResetWhichMovesNothing) {
  SafeRig rig;
  rig.send(by(0.5));
  rig.run(200);
  rig.operators.press();
  rig.run(300);
  ASSERT_FALSE(rig.hardware.powered);
  const double stands = rig.seen().joints[0];
  EXPECT_EQ(recover(rig), ErrorCode::emergency_stop) << "it has not been reset";
  rig.effector.enable(true);
  rig.run(5);
  EXPECT_FALSE(rig.hardware.powered);

  rig.operators.reset();
  ASSERT_TRUE(rig.send(by(0.1)));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::emergency_stop) << "the fault waits for recover";
  rig.run(500);
  EXPECT_FALSE(rig.hardware.powered);
  EXPECT_EQ(rig.seen().joints[0], stands);

  EXPECT_EQ(recover(rig), ErrorCode::none);
  rig.run(500);
  EXPECT_TRUE(rig.hardware.powered);
  EXPECT_EQ(rig.seen().desired.position[0], stands) << "recovered, it holds";
  ASSERT_FALSE(rig.send(by(0.1)));
  rig.run(700);
  EXPECT_NEAR(rig.seen().joints[0], stands + 0.1, 2e-4);
}

TEST(EmergencyStop, AnInputHasToBeLetGoAndThenReset) {
  SafeRig rig(false);
  rig.hardware.close(kTerminal);
  rig.servo.use_emergency_terminal(kTerminal);
  rig.run(1);
  bool pressed = false;
  rig.hardware.spoil = [&pressed](HardwareInput& input) { input.inputs.set(kTerminal, !pressed); };
  rig.effector.enable(true);
  rig.run(2);
  ASSERT_TRUE(rig.hardware.powered);
  pressed = true;
  rig.run(2);
  EXPECT_FALSE(rig.hardware.powered) << "at rest there is nothing to brake";
  EXPECT_EQ(recover(rig), ErrorCode::emergency_stop);
  rig.operators.reset();
  EXPECT_EQ(recover(rig), ErrorCode::emergency_stop) << "still pressed";
  pressed = false;
  EXPECT_EQ(recover(rig), ErrorCode::emergency_stop) << "the reset came too early";
  rig.operators.reset();
  EXPECT_EQ(recover(rig), ErrorCode::none);
}

TEST(EmergencyStop, DoesNotHideOtherFaultsAndIsNotHidden) {
  SafeRig rig;
  rig.hardware.fault = ErrorCode::drive_fault;
  rig.run(2);
  rig.operators.press();
  rig.hardware.fault = ErrorCode::none;
  rig.run(2);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::drive_fault);
  EXPECT_EQ(recover(rig), ErrorCode::emergency_stop) << "the cause that keeps the drives off now";
}

TEST(EmergencyLatch, RegistersEveryPressAndIgnoresEarlyResets) {
  clock::EmergencyStop stop;
  EmergencyLatch latch;
  latch.use(stop);
  EXPECT_FALSE(latch.check({}));
  stop.press();
  stop.reset();  // both between two polls
  EXPECT_TRUE(latch.check({}));
  EXPECT_TRUE(latch.check({}));
  stop.reset();
  EXPECT_FALSE(latch.check({}));
  stop.reset();
  EXPECT_FALSE(latch.check({}));
  stop.press();
  EXPECT_TRUE(latch.check({})) << "an early reset has no effect";
  stop.press();
  stop.reset();
  EXPECT_TRUE(latch.check({}));
}

}  // namespace
}  // namespace mrroc::edp::emergency_stop_test
