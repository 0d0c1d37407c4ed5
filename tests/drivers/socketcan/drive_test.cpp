#include "drivers/socketcan/drive.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "canopen/emergency.hpp"
#include "drive_fixture.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

TEST_F(DriveTest, ReportsTheSwitchesOfItsAxisAlsoWithAReversedCounter) {
  config::DriveTable backwards = table;
  backwards.drives[0].units_per_turn *= -1;
  Drive reversed(backwards, backwards.drives[0], kCanPeriod, 0);
  reversed.begin(0);
  for (const std::uint32_t inputs : {0U, kNegativeLimitSwitch, kPositiveLimitSwitch, kHomeSwitch}) {
    can::Frame status{0x281, {0, 0, 0, 0, 0, 0, 0, 0}}, next;
    can::put(status.data, 4, 4, inputs);
    for (Drive* each : {&drive, &reversed}) {
      EXPECT_TRUE(each->take(status, ++tick, next));
      const AxisSwitches switches = each->switches();
      EXPECT_EQ(switches.lower_limit, inputs == (each == &drive ? kNegativeLimitSwitch : kPositiveLimitSwitch));
      EXPECT_EQ(switches.upper_limit, inputs == (each == &drive ? kPositiveLimitSwitch : kNegativeLimitSwitch));
      EXPECT_EQ(switches.synchro, inputs == kHomeSwitch);
    }
  }
}

TEST_F(DriveTest, TargetsAreFollowedOnlyWhenTheDriveIsOn) {
  say(status_bits(DriveState::switched_on), 100);
  drive.enable(true, tick);
  const auto target = [this] { return can::sign_extended(can::get(drive.command({0, 1.0, 0}).bytes(), 2, 4), 4); };
  EXPECT_EQ(target(), 100) << "its position";
  say(status_bits(DriveState::operation_enabled), 100);
  EXPECT_EQ(target(), 637) << "1 rad at 4000 units per turn";
}

TEST_F(DriveTest, ReadsItsShaftAndItsCurrent) {
  say(status_bits(DriveState::operation_enabled), -2000, -500);
  EXPECT_DOUBLE_EQ(drive.position(), -std::numbers::pi);
  EXPECT_DOUBLE_EQ(drive.current(), -5.0);
}

/// A drive with a reversed counter of 65536 units per turn, and its velocity in revolutions per minute.
TEST(DriveUnits, VelocityUnitsMayDifferFromPositionUnits) {
  for (const DriveMode mode : {DriveMode::cyclic_position, DriveMode::cyclic_velocity}) {
    config::DriveTable table = table_for(Slide{}.parameters(), mode);
    config::DriveEntry& entry = table.drives[0];
    entry.units_per_turn = -65536;
    entry.velocity_units_per_turn = -60;
    entry.position_gain = 2;
    Drive drive(table, entry, kCanPeriod, 0);
    drive.begin(0);
    drive.enable(true, 0);
    can::Frame next, frame{0x181, {0, 0, 0, 0, 0, 0, 0, 0}};
    can::put(frame.data, 0, 2, status_bits(DriveState::operation_enabled));
    ASSERT_TRUE(drive.take(frame, 1, next));
    can::Frame status{0x281, {0, 0, 0, 0, 0, 0, 0, 0}};
    can::put(status.data, 0, 4, static_cast<std::uint32_t>(-90));
    ASSERT_TRUE(drive.take(status, 1, next));
    EXPECT_DOUBLE_EQ(drive.velocity(), 3 * std::numbers::pi);
    // half a turn away, and a turn per second: 2 of half a turn more
    const can::Frame command = drive.command({0, std::numbers::pi, 2 * std::numbers::pi});
    const std::int64_t target = can::sign_extended(can::get(command.bytes(), 2, 4), 4);
    EXPECT_EQ(target, mode == DriveMode::cyclic_position ? -32768 : -120);
    can::put(frame.data, 2, 4, 16384);  // it holds the position at which it switched on
    ASSERT_TRUE(drive.take(frame, 2, next));
    const std::int64_t held = can::sign_extended(can::get(drive.hold(true).bytes(), 2, 4), 4);
    EXPECT_EQ(held, mode == DriveMode::cyclic_position ? 0 : -30);
  }
}

TEST_F(DriveTest, PositionContinuesBeyond32Bits) {
  switch_on();
  say(status_bits(DriveState::operation_enabled), 0x7ffffff0);
  say(status_bits(DriveState::operation_enabled), -0x7ffffff0);
  EXPECT_DOUBLE_EQ(drive.position(), 0x80000010p0 * 2 * std::numbers::pi / 4000);
  const double beyond = drive.position() + 2 * std::numbers::pi / 4000;
  EXPECT_EQ(can::sign_extended(can::get(drive.command({0, beyond, 0}).bytes(), 2, 4), 4), -0x7fffffef);
}

TEST_F(DriveTest, EmergencyIsKeptUntilItsReset) {
  switch_on();
  can::Frame next;
  drive.take(to_frame({1, 0x3220, 1, {}}), tick, next);
  say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_fault);
  EXPECT_EQ(std::get<DriveError>(drive.fault(tick)).code, 0x3220);
  drive.take(to_frame({1, 0, 0, {}}), tick, next);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_fault) << "it may have been too short to be seen";
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
}

TEST_F(DriveTest, DrivesFollowingErrorIsReportedAsOurs) {
  switch_on();
  say(static_cast<std::uint16_t>(status_bits(DriveState::operation_enabled) | kFollowingError));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::following_error);
}

TEST_F(DriveTest, HomingUsesOnlyReportsAfterItsStart) {
  beats = true;
  has_display = false;
  constexpr auto kOn = DriveState::operation_enabled;
  const auto homing = [](std::uint16_t more) { return static_cast<std::uint16_t>(status_bits(kOn) | more); };
  const auto start = [&] {
    drive.home();
    while ((controlword() & kStartHoming) == 0) say(homing(kHomingError | kHomingAttained | kTargetReached));
  };
  switch_on();
  start();
  EXPECT_GT(tick, 20u) << "the time for the mode change is over";
  // the report of the last attempt does not count for this one
  for (int i = 0; i < 5; ++i) say(homing(kHomingError | kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::running);
  for (int i = 0; i < 50; ++i) say(homing(0));
  EXPECT_EQ(drive.homing(), Homing::running);
  say(homing(kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::attained);
  // a drive that is already at home reports nothing else
  start();
  for (int i = 0; i < 200; ++i) say(homing(kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::running);
  for (int i = 0; i < 60; ++i) say(homing(kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::attained);
  say(homing(kFollowingError));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::following_error) << "it controls its position again";
}

TEST_F(DriveTest, HomingThatDoesNotEndHasFailed) {
  beats = true;
  switch_on();
  drive.home();
  const auto ticks = static_cast<Tick>(HomingRun::kLongestTime / kCanPeriod);
  for (Tick i = 0; i <= ticks; ++i) say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.homing(), Homing::running) << "the mode change does not count";
  for (Tick i = 0; i < 10; ++i) say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.homing(), Homing::failed);
}

}  // namespace
}  // namespace mrroc::edp
