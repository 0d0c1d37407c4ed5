// A shaft that stands is stuck only when its drive had the set-points that it does not follow.
#include "edp/safety/motion_watch.hpp"

#include <gtest/gtest.h>

#include "edp/test_robots.hpp"

namespace mrroc::edp::motion_watch_test {
namespace {

constexpr double kPeriod = 0.002;

/// A slide whose shaft reads the same position at all times, while its set-point continues by `kStep` in each tick.
class StandingShaft {
 public:
  StandingShaft() { tick(true, 0); }

  /// The verdict about a reading that is new or not, at which the drive lacked the set-points of `unseen` ticks.
  ErrorCode tick(bool is_new, std::uint64_t unseen) {
    set_point_[0] += kStep;
    ++now_;
    if (is_new) taken_ = now_;
    return watch_
        .check(model_, {zero_, zero_, zero_, set_point_, zero_, false}, {static_cast<double>(taken_), 0, unseen}, true,
               -1)
        .code;
  }
  /// Ticks for which the set-point may continue.
  Tick most() const { return static_cast<Tick>(model_.parameters().axes[0].stuck_max / kStep); }

 private:
  static constexpr double kStep = 0.01;
  class Watched : public Slide {
   public:
    Watched() { parameters_.axes[0].stuck_max = 0.255; }
  };

  Watched model_;
  MotionWatch watch_{kPeriod};
  JointVector zero_ = JointVector::Zero(1), set_point_ = zero_;
  Tick now_ = 0, taken_ = 0;
};

TEST(StuckShaft, IsFoundWhenItsSetPointHasContinuedByTheLimit) {
  StandingShaft shaft;
  for (Tick i = 0; i < shaft.most(); ++i) EXPECT_EQ(shaft.tick(true, 0), ErrorCode::none) << i;
  EXPECT_EQ(shaft.tick(true, 0), ErrorCode::axis_stuck);
}

TEST(StuckShaft, IsFoundInReadingsThatAreNotNew) {
  StandingShaft shaft;  // whose driver does not report that it is silent
  for (Tick i = 0; i < shaft.most(); ++i) EXPECT_EQ(shaft.tick(false, 0), ErrorCode::none) << i;
  EXPECT_EQ(shaft.tick(false, 0), ErrorCode::axis_stuck);
}

TEST(StuckShaft, IsNotFoundWhileTheDriveHasOldSetPointsOnly) {
  StandingShaft shaft;
  for (std::uint64_t i = 1; i < 200; ++i) EXPECT_EQ(shaft.tick(true, i), ErrorCode::none) << i;
  EXPECT_EQ(shaft.tick(true, 3), ErrorCode::axis_stuck) << "they have come, and it stands";
}

TEST(StuckShaft, IsFoundSoMuchLaterAsTheDriveIsBehind) {
  for (const std::uint64_t behind : {1u, 5u, 511u}) {
    StandingShaft shaft;
    Tick ticks = 1;
    while (shaft.tick(true, behind) == ErrorCode::none && ticks < 2000) ++ticks;
    EXPECT_EQ(ticks, shaft.most() + 1 + behind);
  }
}

TEST(StuckShaft, IsFoundWhenTheDriveNeverReceivesItsSetPoints) {
  StandingShaft shaft;
  Tick ticks = 1;
  while (shaft.tick(true, ticks) == ErrorCode::none && ticks < 2000) ++ticks;
  EXPECT_EQ(ticks, shaft.most() + SetPointHistory::kLength);
}

}  // namespace
}  // namespace mrroc::edp::motion_watch_test
