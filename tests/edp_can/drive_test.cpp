#include "edp/can/drive.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "canopen/emergency.hpp"
#include "drive_fixture.hpp"
#include "edp/error_report.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

TEST_F(DriveTest, TellsTheSwitchesOfItsAxisAlsoWhenItCountsBackwards) {
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

TEST_F(DriveTest, IsLedStepByStepToOperationEnabled) {
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(controlword(), kDisableVoltage) << "nobody wants it on";
  drive.enable(true, tick);
  EXPECT_EQ(controlword(), kShutdown);
  say(status_bits(DriveState::ready_to_switch_on));
  EXPECT_EQ(controlword(), kSwitchOn);
  say(status_bits(DriveState::switched_on));
  EXPECT_EQ(controlword(), kEnableOperation);
  EXPECT_TRUE(drive.busy(tick));
  say(status_bits(DriveState::operation_enabled));
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  drive.enable(false, tick);
  EXPECT_EQ(controlword(), kQuickStop);
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(controlword(), kDisableVoltage);
}

TEST_F(DriveTest, TargetsFollowOnlyADriveThatIsOn) {
  say(status_bits(DriveState::switched_on), 100);
  drive.enable(true, tick);
  const auto target = [this] { return can::sign_extended(can::get(drive.command({0, 1.0, 0}).bytes(), 2, 4), 4); };
  EXPECT_EQ(target(), 100) << "where it is";
  say(status_bits(DriveState::operation_enabled), 100);
  EXPECT_EQ(target(), 637) << "1 rad of 4000 units a turn";
}

TEST_F(DriveTest, ReadsItsShaftAndItsCurrent) {
  say(status_bits(DriveState::operation_enabled), -2000, -500);
  EXPECT_DOUBLE_EQ(drive.position(), -std::numbers::pi);
  EXPECT_DOUBLE_EQ(drive.current(), -5.0);
}

/// One that counts 65536 units a turn backwards, and its velocity in revolutions per minute.
TEST(DriveUnits, VelocitiesMayBeOthersThanPositions) {
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
    can::put(frame.data, 2, 4, 16384);  // it holds where it has come on
    ASSERT_TRUE(drive.take(frame, 2, next));
    const std::int64_t held = can::sign_extended(can::get(drive.hold(true).bytes(), 2, 4), 4);
    EXPECT_EQ(held, mode == DriveMode::cyclic_position ? 0 : -30);
  }
}

TEST_F(DriveTest, APositionGoesOnBeyond32Bits) {
  switch_on();
  say(status_bits(DriveState::operation_enabled), 0x7ffffff0);
  say(status_bits(DriveState::operation_enabled), -0x7ffffff0);
  EXPECT_DOUBLE_EQ(drive.position(), 0x80000010p0 * 2 * std::numbers::pi / 4000);
  const double beyond = drive.position() + 2 * std::numbers::pi / 4000;
  EXPECT_EQ(can::sign_extended(can::get(drive.command({0, beyond, 0}).bytes(), 2, 4), 4), -0x7fffffef);
}

TEST_F(DriveTest, AnAnswerThatIsMissedIsGuessedTwiceThenItIsSilent) {
  switch_on();
  say(status_bits(DriveState::operation_enabled), 10);
  say(status_bits(DriveState::operation_enabled), 14);
  const double unit = 2 * std::numbers::pi / 4000;
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 18 * unit);
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 22 * unit);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  say_nothing();
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::hardware_silent);
  EXPECT_FALSE(drive.awaited());
}

TEST_F(DriveTest, WhoAlwaysAnswersTooLateIsNotTakenForOneThatAnswers) {
  switch_on();
  const double unit = 2 * std::numbers::pi / 4000;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(drive.finding(tick).code, ErrorCode::none) << i;
    say_late(10 * (i + 1));
  }
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::hardware_silent);
  const Drive::Finding finding = drive.finding(tick);
  const Fault fault{finding.code, 0, finding.value, finding.limit, 7};
  EXPECT_EQ(make_report(fault, Slide{}.parameters()).detail.view(),
            "axis 1 (x), tick 7: its answers come later than answer_time after more than 2 SYNCs in a row");
  can::Frame next;
  drive.reset(tick, next);
  EXPECT_EQ(next.id, 0u) << "it is in service, and need not be set up anew";
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::hardware_silent) << "nothing is better yet";
  say(status_bits(DriveState::operation_enabled), 40);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  EXPECT_DOUBLE_EQ(drive.position(), 40 * unit);
}

TEST_F(DriveTest, AGuessIsMadeOfPositionsThatHaveComeNotOfGuesses) {
  switch_on();
  const double unit = 2 * std::numbers::pi / 4000;
  const std::uint16_t on = status_bits(DriveState::operation_enabled);
  say(on, 10);
  say(on, 14);
  say_nothing();  // guessed to be at 18
  say(on, 22);
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 26 * unit) << "4 of each SYNC, also of the one without an answer";
  say(on, 30);
  say_late(34);
  say_nothing();
  EXPECT_DOUBLE_EQ(drive.position(), 38 * unit) << "one that comes late is as good to guess from";
}

TEST_F(DriveTest, SwitchesThatAreNotToldAreMissed) {
  switch_on();
  tells_switches = false;
  for (int i = 0; i < 12; ++i) {  // three times status_every
    EXPECT_EQ(drive.finding(tick).code, ErrorCode::none) << i;
    say(status_bits(DriveState::operation_enabled));
  }
  say(status_bits(DriveState::operation_enabled));
  const Drive::Finding finding = drive.finding(tick);
  EXPECT_EQ(finding.code, ErrorCode::hardware_silent);
  EXPECT_EQ(make_report({finding.code, 0, finding.value, finding.limit, 7}, Slide{}.parameters()).detail.view(),
            "axis 1 (x), tick 7: no TPDO 2, velocity and switches, after more than 12 SYNCs in a row");
  can::Frame next;
  drive.reset(tick, next);
  EXPECT_EQ(next.id, 0x601u) << "it is set up anew";
}

TEST_F(DriveTest, AFrameThatIsTooShortIsNoAnswer) {
  can::Frame frame{0x181, {0x37, 0x16, 1, 0, 0, 0, 0}};
  cycle(frame);
  EXPECT_FALSE(drive.answered());
}

TEST_F(DriveTest, AnEmergencyIsKeptUntilItIsReset) {
  switch_on();
  can::Frame next;
  drive.take(to_frame({1, 0x3220, 1, {}}), tick, next);
  say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::drive_fault);
  EXPECT_EQ(drive.finding(tick).value, 0x3220);
  drive.take(to_frame({1, 0, 0, {}}), tick, next);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::drive_fault) << "it may have gone too soon to be seen";
  drive.reset(tick, next);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
}

TEST_F(DriveTest, AFaultIsResetByEdges) {
  switch_on();
  say(status_bits(DriveState::fault));
  const Drive::Finding finding = drive.finding(tick);
  EXPECT_EQ(finding.code, ErrorCode::drive_fault);
  EXPECT_EQ(make_report({finding.code, 0, finding.value, finding.limit, 7}, Slide{}.parameters()).detail.view(),
            "axis 1 (x), tick 7: fault, no EMCY");
  can::Frame next;
  drive.reset(tick, next);
  EXPECT_TRUE(drive.busy(tick));
  EXPECT_EQ(controlword(), kFaultReset);
  EXPECT_EQ(controlword(), kDisableVoltage);
  EXPECT_EQ(controlword(), kFaultReset);
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(controlword(), kDisableVoltage);
  EXPECT_FALSE(drive.busy(tick));
}

TEST_F(DriveTest, AResetLetsAStopUnderWayEnd) {
  beats = true;
  switch_on();
  drive.enable(false, tick);
  EXPECT_EQ(controlword(), kQuickStop);
  say(status_bits(DriveState::quick_stop_active));
  can::Frame next;
  drive.reset(tick, next);
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(drive.busy(tick));
    EXPECT_EQ(controlword(), kQuickStop);
    say(status_bits(DriveState::quick_stop_active));
  }
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(controlword(), kDisableVoltage);
  // however often it is reset: a stop that does not end loses the power
  drive.enable(true, tick);
  say(status_bits(DriveState::operation_enabled));
  drive.enable(false, tick);
  for (int i = 0; i < 1000; ++i) {
    if (i % 100 == 0) drive.reset(tick, next);
    EXPECT_EQ(controlword(), kQuickStop);
    say(status_bits(DriveState::quick_stop_active));
  }
  EXPECT_EQ(controlword(), kDisableVoltage);
}

TEST_F(DriveTest, ADriveThatSwitchesItselfOffIsNotReady) {
  switch_on();
  say(status_bits(DriveState::switch_on_disabled));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::drive_not_ready);
}

TEST_F(DriveTest, ItsOwnFollowingErrorIsOurs) {
  switch_on();
  say(static_cast<std::uint16_t>(status_bits(DriveState::operation_enabled) | kFollowingError));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::following_error);
}

TEST_F(DriveTest, HeartbeatsAreWatchedOverThreeOfThem) {
  switch_on();
  while (tick < 30) say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::heartbeat_lost);
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::operational), tick, next);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
}

TEST_F(DriveTest, ABootUpInServiceIsARestart) {
  switch_on();
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::drive_restarted);
  EXPECT_FALSE(drive.knows_position());
  drive.reset(tick, next);
  EXPECT_EQ(next.id, 0x601u) << "it is set up anew";
}

TEST_F(DriveTest, WhoeverBootsWhileNobodyServesHimHasLostHisPosition) {
  switch_on();
  for (int i = 0; i < 5; ++i) say_nothing();
  ASSERT_EQ(drive.finding(tick).code, ErrorCode::hardware_silent);
  can::Frame next;
  drive.reset(tick, next);  // nobody answers
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  EXPECT_FALSE(drive.knows_position());
  EXPECT_EQ(next.id, 0x601u) << "what it was told so far is forgotten: from the start";
  EXPECT_EQ(can::get(next.bytes(), 1, 2), 0x1400u);
}

TEST_F(DriveTest, WhoAnswersMoreOftenThanItIsAskedHasANamesake) {
  switch_on();
  const std::uint16_t on = status_bits(DriveState::operation_enabled);
  can::Frame next;
  const auto once_more = [&] { drive.take(feedback(on, 0), tick, next); };
  for (int i = 0; i < 20; ++i) {
    say(on);
    if (i % 2 == 0) once_more();  // now and then: it is not worth a stop
    EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  }
  for (int i = 0; i < 2; ++i) say_nothing();
  say(on);
  for (int i = 0; i < 2; ++i) once_more();  // those that were missed, late
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  for (int i = 0; i < 3; ++i) {
    say(on);
    once_more();
    once_more();  // twice, in one cycle
    EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
  }
  say(on);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::encoder_fault);
  EXPECT_EQ(drive.finding(tick).value, 3) << "cycles";
  say(on);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::encoder_fault) << "until it is reset";
  drive.reset(tick, next);
  EXPECT_NE(drive.finding(tick).code, ErrorCode::encoder_fault);
}

TEST_F(DriveTest, ARequestOfItsSetUpThatIsNotAnsweredIsSentAgain) {
  switch_on();
  can::Frame next, again;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  EXPECT_FALSE(drive.repeats(tick + 1000, again)) << "it is not being set up";
  drive.reset(tick, next);
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
  EXPECT_EQ(again.size, 0u) << "the first one's answer, come late";
  ASSERT_TRUE(drive.repeats(tick + patience + 1, again));
  EXPECT_EQ(again, second);
}

TEST_F(DriveTest, AnAxisStaysWhereItWasWhenItsDriveCountsAnew) {
  switch_on();
  say(status_bits(DriveState::operation_enabled), 1'000'000);
  const double there = drive.position();
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  drive.reset(tick, next);
  say(status_bits(DriveState::switch_on_disabled), 12);
  EXPECT_NEAR(drive.position(), there, 1e-9);
  EXPECT_FALSE(drive.knows_position());
  say(status_bits(DriveState::switch_on_disabled), 4012);
  EXPECT_NEAR(drive.position() - there, 2 * std::numbers::pi, 1e-9) << "and turns on from there";
}

TEST_F(DriveTest, AnAxisThatWasOnlySilentIsWhereItsDriveSays) {
  switch_on();
  constexpr std::int32_t kEnd = std::numeric_limits<std::int32_t>::max();
  say(status_bits(DriveState::operation_enabled), kEnd - 5);
  say(status_bits(DriveState::operation_enabled), -kEnd);  // past the end of 32 bits
  const double before = drive.position();
  for (int i = 0; i < 5; ++i) say_nothing();
  can::Frame next;
  drive.reset(tick, next);
  say(status_bits(DriveState::switch_on_disabled), -kEnd + 2);
  EXPECT_NEAR(drive.position() - before, 2 * 2 * std::numbers::pi / 4000, 1e-6);
}

/// Its boot-up message, which comes once, got lost: it has forgotten what it was told.
TEST_F(DriveTest, AnAxisWhoseDriveHasRestartedUnheardIsNotSynchronised) {
  for (const bool restarted : {false, true}) {
    drive.begin(tick);
    drive.position_known();
    switch_on();
    for (int i = 0; i < 5; ++i) say_nothing();
    can::Frame next;
    drive.reset(tick, next);
    EXPECT_EQ(next, (can::Frame{0x601, {0x40, 0x17, 0x10, 0, 0, 0, 0, 0}}));
    EXPECT_TRUE(drive.knows_position());
    const auto period = static_cast<std::uint8_t>(restarted ? 0 : 1000 * table.heartbeat);
    drive.take({0x581, {0x4b, 0x17, 0x10, 0, period, 0, 0, 0}}, tick, next);
    EXPECT_EQ(drive.knows_position(), !restarted);
    EXPECT_EQ(next.data[0] & 0xe0, 0x20) << "the set-up goes on";
    drive.setup().give_up();
  }
}

TEST_F(DriveTest, TheLastStepToOperationIsTakenWhenItMay) {
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
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::none) << "it is another one that is not ready";
  EXPECT_EQ(held(true), kEnableOperation);
  say(status_bits(DriveState::operation_enabled), 103);
  say(status_bits(DriveState::operation_enabled), 110);
  EXPECT_EQ(static_cast<std::int32_t>(can::get(drive.hold(true).bytes(), 2, 4)), 100) << "it holds where it became on";
}

TEST_F(DriveTest, AStopThatDoesNotEndLosesThePower) {
  beats = true;
  switch_on();
  drive.enable(false, tick);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(controlword(), kQuickStop);
    EXPECT_EQ(drive.finding(tick).code, ErrorCode::none);
    say(status_bits(DriveState::quick_stop_active));
  }
  say(status_bits(DriveState::quick_stop_active));
  EXPECT_EQ(controlword(), kDisableVoltage);
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::drive_not_ready);
}

TEST_F(DriveTest, WhoKeepsItsPowerAgainstItsControlwordDoesNotHearIt) {
  beats = true;
  const auto patience = static_cast<int>(Drive::kObeyTime / kCanPeriod);
  switch_on();
  EXPECT_FALSE(drive.defies());
  drive.enable(false, tick);
  for (int i = 0; i <= patience; ++i) {
    EXPECT_FALSE(drive.defies()) << i;
    EXPECT_EQ(controlword(), kQuickStop);
    say(status_bits(DriveState::operation_enabled));
  }
  EXPECT_TRUE(drive.defies());
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::stopped), tick, next);
  EXPECT_FALSE(drive.defies()) << "it has been stopped";
  drive.reset(tick, next);
  EXPECT_EQ(next.id, 0x601u) << "and is set up anew";
  // one that slows down has the time for it, and then that in which it is to let go
  drive.begin(tick);
  drive.enable(true, tick);
  say(status_bits(DriveState::operation_enabled));
  drive.enable(false, tick);
  for (int i = 0; i <= 1000 + patience; ++i) {
    EXPECT_FALSE(drive.defies()) << i;
    controlword();
    say(status_bits(DriveState::quick_stop_active));
  }
  EXPECT_TRUE(drive.defies());
  say(status_bits(DriveState::switch_on_disabled));
  controlword();
  say(status_bits(DriveState::operation_enabled));
  EXPECT_FALSE(drive.defies()) << "it gets its time again";
}

TEST_F(DriveTest, TheTimeToSwitchOnIsTheTables) {
  beats = true;
  table.switch_on_time = 3;
  drive = Drive(table, table.drives[0], kCanPeriod, 0);
  drive.begin(0);
  drive.enable(true, tick);
  for (int i = 0; i < 1500; ++i) say(status_bits(DriveState::ready_to_switch_on));
  EXPECT_TRUE(drive.busy(tick));
  say(status_bits(DriveState::ready_to_switch_on));
  EXPECT_FALSE(drive.busy(tick));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::drive_not_ready);
}

TEST_F(DriveTest, HomingBelievesWhatItsDriveSaysAfterTheStart) {
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
  EXPECT_GT(tick, 20u) << "the mode has had its time";
  // what it said of the last attempt is not of this one
  for (int i = 0; i < 5; ++i) say(homing(kHomingError | kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::running);
  for (int i = 0; i < 50; ++i) say(homing(0));
  EXPECT_EQ(drive.homing(), Homing::running);
  say(homing(kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::attained);
  // one that is there at once never says anything else
  start();
  for (int i = 0; i < 200; ++i) say(homing(kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::running);
  for (int i = 0; i < 60; ++i) say(homing(kHomingAttained | kTargetReached));
  EXPECT_EQ(drive.homing(), Homing::attained);
  say(homing(kFollowingError));
  EXPECT_EQ(drive.finding(tick).code, ErrorCode::following_error) << "it regulates again";
}

TEST_F(DriveTest, AHomingThatDoesNotEndHasFailed) {
  beats = true;
  switch_on();
  drive.home();
  const auto ticks = static_cast<Tick>(Drive::kLongestHoming / kCanPeriod);
  for (Tick i = 0; i <= ticks; ++i) say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.homing(), Homing::running) << "the mode's change is not of it";
  for (Tick i = 0; i < 10; ++i) say(status_bits(DriveState::operation_enabled));
  EXPECT_EQ(drive.homing(), Homing::failed);
}

TEST_F(DriveTest, ADriveThatRefusesToBeSetUpAnewSaysWhatAndWhy) {
  switch_on();
  can::Frame next;
  drive.take(heartbeat_frame(1, NmtState::boot_up), tick, next);
  drive.reset(tick, next);
  const auto low = next.data[1], high = next.data[2], sub = next.data[3];
  drive.take({0x581, {0x80, low, high, sub, 0x22, 0x00, 0x00, 0x08}}, tick, next);
  Drive::Finding finding = drive.finding(tick);
  const Fault fault{finding.code, 0, finding.value, finding.limit, 7};
  const std::string text{make_report(fault, Slide{}.parameters()).detail.view()};
  char object[16];
  std::snprintf(object, sizeof object, "%02X%02Xh:%u", high, low, sub);
  std::string expected = "axis 1 (x), tick 7: it refuses to be set up: object ";
  expected.append(object).append(", ").append(describe(SdoAbort{0x08000022}));
  EXPECT_EQ(text, expected);
  drive.reset(tick, next);
  EXPECT_EQ(drive.finding(tick).value, 0) << "it is tried again";
}

}  // namespace
}  // namespace mrroc::edp
