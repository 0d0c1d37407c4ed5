#include "mrroc/sensors/infrared.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/infrared/made_sensor.hpp"
#include "sensors/played_task.hpp"

namespace mrroc {
namespace {

/// An `Infrared` whose hardware replays `lines`; non-interactive with `period`.
class InfraredTest : public ::testing::Test {
 protected:
  void play(const std::string& lines, Tick period = 0) {
    task_ = std::make_unique<vsp::PlayedTask>(aggregating_, "infrared", "# mrroc readings range\n" + lines, period);
    eye_ = std::make_unique<Infrared>(*task_, "eye");
  }
  Infrared& eye() { return *eye_; }

 private:
  vsp::InfraredSensor aggregating_ = vsp::made_sensor();
  std::unique_ptr<vsp::PlayedTask> task_;
  std::unique_ptr<Infrared> eye_;
};

TEST_F(InfraredTest, DetectsNothingBeforeTheFirstReading) {
  play("0 0.2\n");
  EXPECT_TRUE(std::isnan(eye().distance()));
  EXPECT_FALSE(eye().detected());
  EXPECT_FALSE(eye().presence());
}

TEST_F(InfraredTest, ConfiguredPresenceAndRangeHoldFromTheNextReadingOn) {
  play("0 0.25\n");
  Wait({}, {eye()}, Presence{eye()});
  eye().configure(PresenceAt{0.2, 0.01});
  Wait({}, {eye()}, Nearer{eye(), 0.5});
  EXPECT_FALSE(eye().presence());
  eye().configure(InfraredRange{0.12, 0.24});
  EXPECT_EQ(eye().configuration(), 2U);
  Wait({}, {eye()}, !Nearer{eye(), 0.5});
  EXPECT_FALSE(eye().detected());
  EXPECT_EQ(eye().distance(), 0.24);
}

TEST_F(InfraredTest, RefusedConfigurationsChangeNothing) {
  play("0 0.25\n");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const PresenceAt& presence :
       {PresenceAt{0.05, 0}, PresenceAt{0.7, 0.2}, PresenceAt{nan, 0}, PresenceAt{0.3, -1}})
    EXPECT_THROW(eye().configure(presence), NonFatalError) << presence.distance;
  for (const InfraredRange& range : {InfraredRange{0.05, 0.5}, InfraredRange{0.2, 0.9}, InfraredRange{0.31, 0.5},
                                     InfraredRange{0.1, 0.31}, InfraredRange{nan, 0.5}})
    EXPECT_THROW(eye().configure(range), NonFatalError) << range.nearest << " " << range.farthest;
  EXPECT_EQ(eye().configuration(), 0U);
  Wait({}, {eye()}, Presence{eye()});
}

TEST_F(InfraredTest, WaitsForPresenceAndItsEnd) {
  play("0 -1\n 40 0.25\n 45 0.31\n 90 0.33\n");
  EXPECT_EQ(Wait({}, {eye()}, Presence{eye()}).end_tick, 40U);
  EXPECT_EQ(Wait({}, {eye()}, !Presence{eye()}).end_tick, 90U);  // default: on at 0.3 m, off beyond 0.32 m
  EXPECT_EQ(eye().distance(), 0.33);
}

TEST_F(InfraredTest, PresenceBetweenTwoReadingsIsDetected) {
  play("0 -1\n 41 0.2\n 42 0.31\n", 50);  // at 42, between on and off: on only because of tick 41
  EXPECT_EQ(Wait({}, {eye()}, Presence{eye()}).end_tick, 50U);
}

TEST_F(InfraredTest, NearerUsesTheDistanceAndIgnoresMissingTargets) {
  play("0 -1\n 20 0.5\n 40 0.29\n");
  const Outcome outcome = Wait({}, {eye()}, Nearer{eye(), 0.3});
  EXPECT_EQ(outcome.end_tick, 40U);
  EXPECT_TRUE(outcome.by("eye nearer than 0.3 m"));
  play("0 -1\n 20 0.5\n");
  EXPECT_EQ(Wait({}, {eye()}, Nearer{eye(), 100}).end_tick, 20U);
}

TEST_F(InfraredTest, TargetInTheDeadZoneEndsTheWaitWithAnError) {
  play("0 -1\n 20 0.05\n");
  EXPECT_THROW(Wait({}, {eye()}, Presence{eye()}), NonFatalError);
}

TEST_F(InfraredTest, RefusesABiasAndInvalidDistances) {
  play("0 0.5\n");
  EXPECT_THROW(eye().bias(), NonFatalError);
  EXPECT_THROW(Nearer(eye(), 0), NonFatalError);
  EXPECT_THROW(Nearer(eye(), std::numeric_limits<double>::quiet_NaN()), NonFatalError);
}

}  // namespace
}  // namespace mrroc
