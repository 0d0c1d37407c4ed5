// The transitions of a drive to operation enabled and back.
#include <gtest/gtest.h>

#include <cstdint>

#include "drive_fixture.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

TEST_F(DriveTest, ReachesOperationEnabledStepByStep) {
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(controlword(), kDisableVoltage) << "switching on is not requested";
  drive.enable(true, tick);
  EXPECT_EQ(controlword(), kShutdown);
  say(status_bits(DriveState::ready_to_switch_on));
  EXPECT_EQ(controlword(), kSwitchOn);
  say(status_bits(DriveState::switched_on));
  EXPECT_EQ(controlword(), kEnableOperation);
  EXPECT_TRUE(drive.busy(tick));
  say(status_bits(DriveState::operation_enabled));
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  drive.enable(false, tick);
  EXPECT_EQ(controlword(), kQuickStop);
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(controlword(), kDisableVoltage);
}

TEST_F(DriveTest, FaultIsResetByEdges) {
  switch_on();
  say(status_bits(DriveState::fault));
  const DriveFault fault = drive.fault(tick);
  EXPECT_EQ(code_of(fault), ErrorCode::drive_fault);
  EXPECT_EQ(text_of(fault), "axis 1 (x), tick 7: fault, no EMCY");
  can::Frame next;
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_TRUE(drive.busy(tick));
  EXPECT_EQ(controlword(), kFaultReset);
  EXPECT_EQ(controlword(), kDisableVoltage);
  EXPECT_EQ(controlword(), kFaultReset);
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(controlword(), kDisableVoltage);
  EXPECT_FALSE(drive.busy(tick));
}

TEST_F(DriveTest, ResetLetsARunningStopEnd) {
  beats = true;
  switch_on();
  drive.enable(false, tick);
  EXPECT_EQ(controlword(), kQuickStop);
  say(status_bits(DriveState::quick_stop_active));
  can::Frame next;
  drive.reset(tick, drive.position(), !drive.serves(), next);
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(drive.busy(tick));
    EXPECT_EQ(controlword(), kQuickStop);
    say(status_bits(DriveState::quick_stop_active));
  }
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(controlword(), kDisableVoltage);
  // a stop that does not end removes the power, regardless of resets
  drive.enable(true, tick);
  say(status_bits(DriveState::operation_enabled));
  drive.enable(false, tick);
  for (int i = 0; i < 1000; ++i) {
    if (i % 100 == 0) drive.reset(tick, drive.position(), !drive.serves(), next);
    EXPECT_EQ(controlword(), kQuickStop);
    say(status_bits(DriveState::quick_stop_active));
  }
  EXPECT_EQ(controlword(), kDisableVoltage);
}

TEST_F(DriveTest, DriveThatSwitchesItselfOffIsNotReady) {
  switch_on();
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_not_ready);
}

TEST_F(DriveTest, LastStepToOperationWaitsForItsRelease) {
  beats = true;
  drive.enable(true, tick);
  const auto held = [this](bool release) { return can::get(drive.hold(release).bytes(), 0, 2); };
  say(status_bits(DriveState::ready_to_switch_on), 100);
  EXPECT_EQ(held(true), kSwitchOn);
  EXPECT_FALSE(drive.may_operate());
  say(status_bits(DriveState::switched_on), 100);
  EXPECT_TRUE(drive.may_operate());
  EXPECT_EQ(held(false), kSwitchOn);
  for (int i = 0; i < 2000; ++i) say(status_bits(DriveState::switched_on), 100);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none) << "another drive is not ready";
  EXPECT_EQ(held(true), kEnableOperation);
  say(status_bits(DriveState::operation_enabled), 103);
  say(status_bits(DriveState::operation_enabled), 110);
  EXPECT_EQ(static_cast<std::int32_t>(can::get(drive.hold(true).bytes(), 2, 4)), 100)
      << "it holds the position at which it switched on";
}

TEST_F(DriveTest, StopThatDoesNotEndRemovesThePower) {
  beats = true;
  switch_on();
  drive.enable(false, tick);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(controlword(), kQuickStop);
    EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
    say(status_bits(DriveState::quick_stop_active));
  }
  say(status_bits(DriveState::quick_stop_active));
  EXPECT_EQ(controlword(), kDisableVoltage);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_not_ready);
}

TEST_F(DriveTest, DriveThatKeepsItsPowerIgnoresItsControlword) {
  beats = true;
  const auto timeout = static_cast<int>(DrivePower::kObeyTime / kCanPeriod);
  switch_on();
  EXPECT_FALSE(drive.ignores_controlword());
  drive.enable(false, tick);
  for (int i = 0; i <= timeout; ++i) {
    EXPECT_FALSE(drive.ignores_controlword()) << i;
    EXPECT_EQ(controlword(), kQuickStop);
    say(status_bits(DriveState::operation_enabled));
  }
  EXPECT_TRUE(drive.ignores_controlword());
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::stopped), tick, next);
  EXPECT_FALSE(drive.ignores_controlword()) << "it has been stopped";
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_EQ(next.id, 0x601u) << "and is set up again";
  // a drive that slows down has the time of its stop, and then that for releasing the power
  drive.begin(tick);
  drive.enable(true, tick);
  say(status_bits(DriveState::operation_enabled));
  drive.enable(false, tick);
  for (int i = 0; i <= 1000 + timeout; ++i) {
    EXPECT_FALSE(drive.ignores_controlword()) << i;
    controlword();
    say(status_bits(DriveState::quick_stop_active));
  }
  EXPECT_TRUE(drive.ignores_controlword());
  say(status_bits(DriveState::switch_on_disabled));
  controlword();
  say(status_bits(DriveState::operation_enabled));
  EXPECT_FALSE(drive.ignores_controlword()) << "its timeout starts again";
}

TEST_F(DriveTest, TimeToSwitchOnIsThatOfTheTable) {
  beats = true;
  table.switch_on_time = 3;
  drive = Drive(table, table.drives[0], kCanPeriod, 0);
  drive.begin(0);
  drive.enable(true, tick);
  for (int i = 0; i < 1500; ++i) say(status_bits(DriveState::ready_to_switch_on));
  EXPECT_TRUE(drive.busy(tick));
  say(status_bits(DriveState::ready_to_switch_on));
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_not_ready);
}

}  // namespace
}  // namespace mrroc::edp
