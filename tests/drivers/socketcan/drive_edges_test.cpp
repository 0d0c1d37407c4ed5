// The state machines of a drive take every edge of their tables and no other; laws of its position and its answers.
#include <gtest/gtest.h>

#include <random>

#include "drivers/socketcan/drive_answers.hpp"
#include "drivers/socketcan/drive_position.hpp"
#include "drivers/socketcan/drive_power.hpp"
#include "drivers/socketcan/homing_run.hpp"
#include "edp/edges.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

constexpr double kStep = 0.002;  // s

int draw(std::mt19937& random, int below) { return std::uniform_int_distribution<int>(0, below - 1)(random); }

TEST(DrivePower, TakesEveryEdgeOfItsTableAndNoOther) {
  using S = DrivePower::State;
  const EdgeTable<S> table{{S::off, S::switching_on},
                           {S::resetting, S::resetting_first},
                           {S::switching_on, S::waiting},
                           {S::waiting, S::switching_on},
                           {S::switching_on, S::on},
                           {S::waiting, S::on},
                           {S::switching_on, S::off},
                           {S::waiting, S::off},
                           {S::on, S::off},
                           {S::resetting_first, S::resetting},
                           {S::resetting, S::off},
                           {S::resetting_first, S::switching_on},
                           {S::off, S::resetting},
                           {S::switching_on, S::resetting},
                           {S::waiting, S::resetting},
                           {S::on, S::resetting},
                           {S::on, S::switching_on}};
  std::mt19937 random(402);
  DrivePower power(1, kStep);
  Edges<S> seen;
  std::uint16_t before = 0;
  for (Tick tick = 1; tick < 200'000; ++tick) {
    const S from = power.state();
    const auto now = static_cast<DriveState>(draw(random, 8));
    const int event = draw(random, 12);
    if (event == 0) {
      power.enable(true, tick);
    } else if (event == 1) {
      power.enable(false, tick);
    } else if (event == 2) {
      power.reset(tick);
    } else if (event < 6) {
      power.update(now);
    } else {
      const bool release = draw(random, 2) == 0;
      const std::uint16_t word = power.command(now, draw(random, 3) == 0, release);
      if (from == S::off || power.resets()) {
        EXPECT_TRUE(word == kDisableVoltage || word == kQuickStop || word == kFaultReset) << word;
      }
      if (now == DriveState::switched_on && !release) {
        EXPECT_NE(word, kEnableOperation) << "the last step before the release";
      }
      EXPECT_FALSE(word == kFaultReset && before == kFaultReset) << "no edge";
      before = word;
    }
    if (power.state() != from) ++seen[{from, power.state()}];
    EXPECT_FALSE(power.is_wrong(DriveState::operation_enabled, tick) && power.wanted());
  }
  expect_all_of(seen, table);
}

TEST(HomingRun, TakesEveryEdgeOfItsTableAndNoOther) {
  using P = HomingRun::Phase;
  EdgeTable<P> table{{P::none, P::selecting},     {P::attained, P::selecting}, {P::failed, P::selecting},
                     {P::selecting, P::starting}, {P::starting, P::moving},    {P::starting, P::leaving},
                     {P::moving, P::leaving},     {P::starting, P::failed},    {P::moving, P::failed},
                     {P::leaving, P::attained},   {P::starting, P::attained},  {P::moving, P::attained}};
  for (const P phase : {P::selecting, P::starting, P::moving, P::leaving, P::attained, P::failed})
    table.insert({phase, P::none});
  std::mt19937 random(6);
  Edges<P> seen;
  for (const bool available : {true, false}) {
    ModeDisplay display(1, canopen::kModeDisplay, available, kStep);
    HomingRun run(DriveMode::cyclic_position, kStep);
    std::uint16_t word = 0;
    for (Tick tick = 1; tick < 300'000; ++tick) {
      const P from = run.phase();
      can::Frame question, next;
      if (display.asks(tick, question) && draw(random, 3) != 0) {
        const bool late = draw(random, 4) == 0;
        const auto shown = late ? std::uint8_t{1} : static_cast<std::uint8_t>(display.wanted());
        display.take({0x581, {0x4f, 0x61, 0x60, 0, shown, 0, 0, 0}}, next);
      }
      const bool rests = from == P::none || from == P::attained || from == P::failed;
      if (rests && draw(random, 5) == 0) {
        run.begin(display);
      } else if (draw(random, 600) == 0) {
        run.cancel();
      } else {
        if (draw(random, 300) == 0) {
          const std::uint16_t words[]{0, kHomingAttained, kHomingAttained | kTargetReached};
          word = words[draw(random, 3)];
        }
        run.update(draw(random, 900) == 0 ? kHomingError : word, display);
      }
      if (run.phase() != from) ++seen[{from, run.phase()}];
      EXPECT_EQ(run.runs(), run.selects_homing() || run.phase() == P::leaving);
    }
  }
  expect_all_of(seen, table);
}

TEST(DrivePosition, ContinuesBeyondTheEndsOfTheCounterInBothDirections) {
  std::mt19937_64 random(32);
  for (const double unit : {1e-3, -2e-4}) {
    DrivePosition position(unit, true, 1'000'000);
    std::int64_t way = 0, speed = 1 << 22;
    for (int i = 0; i < 20'000; ++i) {
      if (random() % 1000 == 0) speed = -speed;
      way += speed;
      position.expect();
      position.take(static_cast<std::int32_t>(static_cast<std::uint32_t>(way)), false);
      ASSERT_EQ(position.raw(), way);
      ASSERT_DOUBLE_EQ(position.position(), static_cast<double>(way) * unit);
    }
  }
}

TEST(DrivePosition, RevertsAllButARestart) {
  DrivePosition position(0.5, false, 1000);
  position.expect();
  position.take(100, false);
  position.save();
  position.lose();
  position.take(-7'000'000, false);
  position.revert();
  EXPECT_EQ(position.raw(), 100);
  EXPECT_EQ(position.offset(), 0);
  EXPECT_TRUE(position.lost());
}

TEST(DriveAnswers, MoreAnswersThanSyncsMeanADuplicateNode) {
  std::mt19937 random(7);
  DriveAnswers answers(2, 4);
  answers.begin();
  int owed = 0;
  for (int cycle = 0; cycle < 20'000; ++cycle) {
    answers.expect();
    owed = std::min(owed + 1, 16);
    int come = draw(random, 3);
    bool too_many = false;
    for (; come > 0; --come) {
      if (owed > 0)
        --owed;
      else
        too_many = true;
      answers.take();
    }
    const bool spoke = answers.answered_this_cycle();
    const DriveAnswers::Cycle closed = answers.close();
    EXPECT_EQ(closed == DriveAnswers::Cycle::too_many, too_many);
    EXPECT_EQ(closed == DriveAnswers::Cycle::nothing, !spoke);
    EXPECT_EQ(answers.answered(), spoke && !too_many);
    EXPECT_FALSE(answers.may_extrapolate() && answers.is_missed());
  }
}

}  // namespace
}  // namespace mrroc::edp
