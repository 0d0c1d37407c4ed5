// Drives with missing, late or extra answers, and a drive that restarts.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

#include "drive_fixture.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

TEST_F(DriveTest, MissingAnswerIsExtrapolatedTwiceThenTheDriveIsSilent) {
  switch_on();
  say(status_bits(DriveState::operation_enabled), 10);
  say(status_bits(DriveState::operation_enabled), 14);
  const double unit = 2 * std::numbers::pi / 4000;
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 18 * unit);
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 22 * unit);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  say_nothing();
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::hardware_silent);
  EXPECT_FALSE(drive.awaited());
}

TEST_F(DriveTest, DriveThatAlwaysAnswersLateIsSilent) {
  switch_on();
  const double unit = 2 * std::numbers::pi / 4000;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none) << i;
    say_late(10 * (i + 1));
  }
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::hardware_silent);
  const DriveFault fault = drive.fault(tick);
  EXPECT_EQ(text_of(fault),
            "axis 1 (x), tick 7: its answers come later than answer_time after more than 2 SYNCs in a row");
  can::Frame next;
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_EQ(next.id, 0u) << "it is in service and needs no new set-up";
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::hardware_silent) << "the fault persists";
  say(status_bits(DriveState::operation_enabled), 40);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  EXPECT_DOUBLE_EQ(drive.position(), 40 * unit);
}

TEST_F(DriveTest, ExtrapolationUsesOnlyReceivedPositions) {
  switch_on();
  const double unit = 2 * std::numbers::pi / 4000;
  const std::uint16_t on = status_bits(DriveState::operation_enabled);
  say(on, 10);
  say(on, 14);
  say_nothing();  // extrapolated to 18
  say(on, 22);
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 26 * unit) << "4 for each SYNC, also for the one without an answer";
  say(on, 30);
  say_late(34);
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 38 * unit) << "a late position is equally valid for the extrapolation";
}

/// Two nodes have its number; either may be the last to answer.
TEST_F(DriveTest, CycleWithAnExtraAnswerIsIgnored) {
  beats = true;
  const std::uint16_t on = status_bits(DriveState::operation_enabled);
  const double unit = 2 * std::numbers::pi / 4000;
  for (const bool impostor_is_last : {false, true}) {
    drive = Drive(table, table.drives[0], kCanPeriod, 0);
    drive.begin(tick);
    switch_on();
    say(on, 4);
    for (int i = 2; i <= 4; ++i) {
      EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none) << i;
      EXPECT_EQ(controlword(), kEnableOperation);
      can::Frame next;
      const can::Frame strange = feedback(0xd245, 123456789, 32000);
      if (!impostor_is_last) drive.take(strange, tick, next);
      drive.expect();
      ++tick;
      drive.take(feedback(on, 4 * i), tick, next);
      drive.take(heartbeat_frame(1, NmtState::operational), tick, next);
      if (impostor_is_last) drive.take(strange, tick, next);
      drive.close_cycle();
      EXPECT_FALSE(drive.answered());
      EXPECT_NEAR(drive.position(), 4 * std::min(i, 3) * unit, 1e-9) << "extrapolated for two cycles";
      EXPECT_EQ(drive.current(), 0);
    }
    EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::encoder_fault);
    EXPECT_EQ(std::get<DuplicateNode>(drive.fault(tick)).cycles, 3);
  }
}

TEST_F(DriveTest, MissingSwitchReportsAreAFault) {
  switch_on();
  tells_switches = false;
  for (int i = 0; i < 12; ++i) {  // three times status_every
    EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none) << i;
    say(status_bits(DriveState::operation_enabled));
  }
  say(status_bits(DriveState::operation_enabled));
  const DriveFault fault = drive.fault(tick);
  EXPECT_EQ(code_of(fault), ErrorCode::hardware_silent);
  EXPECT_EQ(text_of(fault), "axis 1 (x), tick 7: no TPDO 2, velocity and switches, after more than 12 SYNCs in a row");
  can::Frame next;
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_EQ(next.id, 0x601u) << "it is set up again";
}

TEST_F(DriveTest, ShortFrameIsNoAnswer) {
  can::Frame frame{0x181, {0x37, 0x16, 1, 0, 0, 0, 0}};
  cycle(frame);
  EXPECT_FALSE(drive.answered());
}

TEST_F(DriveTest, HeartbeatTimeoutIsThreePeriods) {
  switch_on();
  while (tick < 30) say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::heartbeat_lost);
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::operational), tick, next);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
}

TEST_F(DriveTest, BootUpInServiceIsARestart) {
  switch_on();
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::drive_restarted);
  EXPECT_FALSE(drive.knows_position());
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_EQ(next.id, 0x601u) << "it is set up again";
}

/// Its last positions may be invalid, like those of a drive whose supply has failed.
TEST_F(DriveTest, DriveThatCountsFromZeroContinuesAtItsAssumedPosition) {
  const double unit = 2 * std::numbers::pi / 4000;
  const std::int64_t turn_over = std::int64_t{1} << 32;
  can::Frame next;
  for (const std::int64_t believed : {1000L, -70000L, turn_over + 5, -3 * turn_over - 7}) {
    switch_on();
    say(status_bits(DriveState::operation_enabled), 1000);
    say(status_bits(DriveState::operation_enabled), -2000000000);
    drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
    drive.reset(tick, static_cast<double>(believed) * unit, !drive.serves(), next);
    drive.begin(tick);
    say(status_bits(DriveState::switch_on_disabled), 3);
    EXPECT_NEAR(drive.position(), static_cast<double>(believed) * unit, 1e-5);
    say(status_bits(DriveState::switch_on_disabled), 7);
    EXPECT_NEAR(drive.position(), static_cast<double>(believed + 4) * unit, 1e-5);
    EXPECT_FALSE(drive.knows_position());
    // a drive that has not restarted has continued counting
    drive.position_known();
    for (int i = 0; i < 5; ++i) say_nothing();
    drive.reset(tick, drive.position(), !drive.serves(), next);
    drive.begin(tick);
    say(status_bits(DriveState::switch_on_disabled), 9);
    EXPECT_NEAR(drive.position(), static_cast<double>(believed + 6) * unit, 1e-5);
  }
}

TEST_F(DriveTest, DriveThatBootsWhileOutOfServiceHasLostItsPosition) {
  switch_on();
  for (int i = 0; i < 5; ++i) say_nothing();
  ASSERT_EQ(code_of(drive.fault(tick)), ErrorCode::hardware_silent);
  can::Frame next;
  drive.reset(tick, drive.position(), !drive.serves(), next);  // no answer
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  EXPECT_FALSE(drive.knows_position());
  EXPECT_EQ(next.id, 0x601u) << "the drive has lost its set-up, which starts again";
  EXPECT_EQ(can::get(next.bytes(), 1, 2), 0x1400u);
}

TEST_F(DriveTest, DriveThatAnswersTooOftenHasADuplicate) {
  switch_on();
  const std::uint16_t on = status_bits(DriveState::operation_enabled);
  can::Frame next;
  const auto once_more = [&] { drive.take(feedback(on, 0), tick, next); };
  for (int i = 0; i < 20; ++i) {
    say(on);
    if (i % 2 == 0) once_more();  // occasionally: no reason for a stop
    EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  }
  for (int i = 0; i < 2; ++i) say_nothing();
  say(on);
  for (int i = 0; i < 2; ++i) once_more();  // the missed ones, late
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  for (int i = 0; i < 3; ++i) {
    say(on);
    once_more();
    once_more();  // twice, in one cycle
    EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::none);
  }
  say(on);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::encoder_fault);
  EXPECT_EQ(std::get<DuplicateNode>(drive.fault(tick)).cycles, 3);
  say(on);
  EXPECT_EQ(code_of(drive.fault(tick)), ErrorCode::encoder_fault) << "until it is reset";
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_NE(code_of(drive.fault(tick)), ErrorCode::encoder_fault);
}

TEST_F(DriveTest, UnansweredSetUpRequestIsRepeated) {
  switch_on();
  can::Frame next, again;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  EXPECT_FALSE(drive.repeats(tick + 1000, again)) << "no set-up is running";
  drive.reset(tick, drive.position(), !drive.serves(), next);
  ASSERT_EQ(next.id, 0x601u);
  const auto patience = static_cast<Tick>(Drive::kAnswerTime / kCanPeriod);
  EXPECT_FALSE(drive.repeats(tick + patience, again));
  ASSERT_TRUE(drive.repeats(tick + patience + 1, again));
  EXPECT_EQ(again, next);
  EXPECT_FALSE(drive.repeats(tick + patience + 2, again)) << "once";

  tick += patience + 2;
  can::Frame answer{0x581, {0x60, 0, 0, 0, 0, 0, 0, 0}}, second;
  std::copy_n(next.data.begin() + 1, 3, answer.data.begin() + 1);
  ASSERT_TRUE(drive.take(answer, tick, second));
  EXPECT_EQ(second.id, 0x601u);
  EXPECT_FALSE(drive.repeats(tick + patience, again)) << "the next request has its own time";
  drive.take(answer, tick, again);
  EXPECT_EQ(again.size, 0u) << "the late answer to the first request";
  ASSERT_TRUE(drive.repeats(tick + patience + 1, again));
  EXPECT_EQ(again, second);
}

TEST_F(DriveTest, AxisKeepsItsPositionWhenItsDriveCountsFromZero) {
  switch_on();
  say(status_bits(DriveState::operation_enabled), 1'000'000);
  const double there = drive.position();
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  drive.reset(tick, drive.position(), !drive.serves(), next);
  say(status_bits(DriveState::switch_on_disabled), 12);
  EXPECT_NEAR(drive.position(), there, 1e-9);
  EXPECT_FALSE(drive.knows_position());
  say(status_bits(DriveState::switch_on_disabled), 4012);
  EXPECT_NEAR(drive.position() - there, 2 * std::numbers::pi, 1e-9) << "and continues from there";
}

TEST_F(DriveTest, SilentAxisIsAtThePositionOfItsDrive) {
  switch_on();
  constexpr std::int32_t kEnd = std::numeric_limits<std::int32_t>::max();
  say(status_bits(DriveState::operation_enabled), kEnd - 5);
  say(status_bits(DriveState::operation_enabled), -kEnd);  // past the end of 32 bits
  const double before = drive.position();
  for (int i = 0; i < 5; ++i) say_nothing();
  can::Frame next;
  drive.reset(tick, drive.position(), !drive.serves(), next);
  say(status_bits(DriveState::switch_on_disabled), -kEnd + 2);
  EXPECT_NEAR(drive.position() - before, 2 * 2 * std::numbers::pi / 4000, 1e-6);
}

/// Its only boot-up message was lost: the drive has lost its set-up.
TEST_F(DriveTest, AxisIsNotSynchronisedAfterAnUnreportedRestart) {
  for (const bool restarted : {false, true}) {
    drive.begin(tick);
    drive.position_known();
    switch_on();
    for (int i = 0; i < 5; ++i) say_nothing();
    can::Frame next;
    drive.reset(tick, drive.position(), !drive.serves(), next);
    EXPECT_EQ(next, (can::Frame{0x601, {0x40, 0x17, 0x10, 0, 0, 0, 0, 0}}));
    EXPECT_TRUE(drive.knows_position());
    const auto period = static_cast<std::uint8_t>(restarted ? 0 : 1000 * table.heartbeat);
    drive.take({0x581, {0x4b, 0x17, 0x10, 0, period, 0, 0, 0}}, tick, next);
    EXPECT_EQ(drive.knows_position(), !restarted);
    EXPECT_EQ(next.data[0] & 0xe0, 0x20) << "the set-up continues";
    drive.setup().give_up();
  }
}

TEST_F(DriveTest, DriveThatRefusesItsSetUpReportsObjectAndReason) {
  switch_on();
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  drive.reset(tick, drive.position(), !drive.serves(), next);
  const auto low = next.data[1], high = next.data[2], sub = next.data[3];
  drive.take({0x581, {0x80, low, high, sub, 0x22, 0x00, 0x00, 0x08}}, tick, next);
  const DriveFault fault = drive.fault(tick);
  const std::string text = text_of(fault);
  char object[16];
  std::snprintf(object, sizeof object, "%02X%02Xh:%u", high, low, sub);
  std::string expected = "axis 1 (x), tick 7: it refuses to be set up: object ";
  expected.append(object).append(", ").append(describe(SdoAbort{0x08000022}));
  EXPECT_EQ(text, expected);
  drive.reset(tick, drive.position(), !drive.serves(), next);
  EXPECT_TRUE(std::holds_alternative<Restarted>(drive.fault(tick))) << "it is tried again";
}

}  // namespace
}  // namespace mrroc::edp
