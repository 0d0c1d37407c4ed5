// The mode of a drive is the displayed one, not the commanded one.
#include <gtest/gtest.h>

#include "drive_fixture.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {
namespace {

constexpr std::uint16_t kHomedWord = kHomingAttained | kTargetReached;

class DriveModeTest : public DriveTest {
 protected:
  DriveModeTest() { beats = true; }
  static std::uint16_t on(std::uint16_t more = 0) {
    return static_cast<std::uint16_t>(status_bits(DriveState::operation_enabled) | more);
  }
  std::string text() const { return text_of(drive.fault(tick)); }
  int mode() { return drive.command({}).data[6]; }
};

TEST_F(DriveModeTest, DriveInAnotherModeIsNotOnYet) {
  told_mode = 1;
  switch_on();
  EXPECT_FALSE(drive.is_on());
  for (int i = 0; i < 500; ++i) {
    EXPECT_TRUE(drive.busy(tick));
    say(on());
  }
  EXPECT_EQ(questions, 101) << "each 10 ms";
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  told_mode = 8;
  for (int i = 0; i < 5; ++i) say(on());
  EXPECT_TRUE(drive.is_on());
  EXPECT_FALSE(drive.busy(tick));
  const int asked = questions;
  for (int i = 0; i < 1000; ++i) say(on());
  EXPECT_EQ(questions, asked) << "a known mode is not requested again";
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
}

TEST_F(DriveModeTest, DriveInAnotherModeIsNotReleased) {
  told_mode = 1;
  drive.enable(true, tick);
  const auto wait = [this](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      drive.hold(drive.may_operate());
      say(status_bits(DriveState::switched_on));
    }
  };
  wait(500);
  EXPECT_FALSE(drive.may_operate());
  EXPECT_TRUE(drive.busy(tick));
  told_mode = 0;  // a drive that reports no mode before it is on
  wait(10);
  EXPECT_TRUE(drive.may_operate());
  drive.enable(true, tick);
  told_mode = 1;
  wait(10);
  EXPECT_FALSE(drive.may_operate());
  told_mode = 8;
  wait(10);
  EXPECT_TRUE(drive.may_operate());
  drive.enable(true, tick);
  told_mode = 1;
  wait(1002);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_not_ready);
  EXPECT_EQ(text(), "axis 1 (x), tick 7: mode display 1, wanted 8");
}

TEST_F(DriveModeTest, DriveThatNeverReportsItsModeIsNotReady) {
  told_mode = 1;
  switch_on();
  for (int i = 0; i < 1000; ++i) say(on());
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_not_ready);
  EXPECT_EQ(text(), "axis 1 (x), tick 7: mode display 1, wanted 8");
}

TEST_F(DriveModeTest, UnansweredRequestIsRepeated) {
  answers = false;
  switch_on();
  for (int i = 0; i < 1000; ++i) say(on());
  EXPECT_EQ(questions, 21) << "each 0.1 s";
  EXPECT_EQ(text(), "axis 1 (x), tick 7: no answer with its mode display (6061h), wanted 8");
  answers = true;
  drive.enable(false, tick);
  say(status_bits(DriveState::switch_on_disabled));
  switch_on();
  EXPECT_TRUE(drive.is_on());
}

TEST_F(DriveModeTest, DriveWithoutAModeDisplayIsAccepted) {
  has_display = false;
  switch_on();
  EXPECT_TRUE(drive.is_on());
  for (int i = 0; i < 1200; ++i) say(on());
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);

  config::DriveTable without = table;
  without.eds = changed_eds("[6061]", "[6f61]");
  Drive other(without, without.drives[0], kCanPeriod, 0);
  other.begin(0);
  other.enable(true, 0);
  can::Frame next;
  other.take(feedback(on(), 0), 1, next);
  EXPECT_TRUE(other.is_on());
  EXPECT_FALSE(other.asks(1, next));
}

TEST_F(DriveModeTest, HomingStartsAndEndsWithTheDisplayedMode) {
  switch_on();
  told_mode = 8;
  drive.home();
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(controlword(), kEnableOperation);
    say(on(kHomedWord));
  }
  EXPECT_EQ(mode(), 6);
  told_mode = 6;
  for (int i = 0; i < 6; ++i) say(on());
  EXPECT_EQ(controlword(), kEnableOperation | kStartHoming);
  for (int i = 0; i < 50; ++i) say(on());
  say(on(kHomedWord));
  EXPECT_EQ(mode(), 8);
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(drive.homing(), Homing::running);
    say(on(kHomedWord));
  }
  EXPECT_EQ(controlword(), kEnableOperation);
  told_mode = 8;
  for (int i = 0; i < 6; ++i) say(on());
  EXPECT_EQ(drive.homing(), Homing::attained);
}

TEST_F(DriveModeTest, DriveThatKeepsItsModeDoesNotHome) {
  switch_on();
  told_mode = 8;
  drive.home();
  for (int i = 0; i < 1000; ++i) say(on(kHomedWord));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  say(on(kHomedWord));
  EXPECT_EQ(text(), "axis 1 (x), tick 7: mode display 8, wanted 6");
}

TEST_F(DriveModeTest, DriveThatStaysInTheHomingModeIsNotReady) {
  switch_on();
  drive.home();
  for (int i = 0; i < 50; ++i) say(on());
  ASSERT_EQ(controlword(), kEnableOperation | kStartHoming);
  told_mode = 6;
  for (int i = 0; i <= 1000; ++i) say(on(kHomedWord));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  say(on(kHomedWord));
  EXPECT_EQ(text(), "axis 1 (x), tick 7: mode display 6, wanted 8");
}

}  // namespace
}  // namespace mrroc::edp
