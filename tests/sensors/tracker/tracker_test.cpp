#include "mrroc/sensors/tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "sensors/played_task.hpp"
#include "sensors/tracker/made_sensor.hpp"

namespace mrroc {
namespace {

TEST(Tracker, GivesThePoseOfItsTarget) {
  vsp::TrackerSensor aggregating = vsp::made_sensor();
  vsp::PlayedTask task(aggregating, "tracker",
                       "# mrroc readings x y z qw qx qy qz\n0 1 2 3 0.5 0.5 0.5 0.5\n20 1.1 2 3 1 0 0 0\n");
  Tracker tracker(task, "tracker");
  EXPECT_TRUE(std::isnan(tracker.pose().translation().x()));
  Wait({}, {tracker}, ElapsedSteps{0});
  EXPECT_EQ(tracker.pose().translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_LT((tracker.pose().linear() * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-12);
  Wait({}, {tracker}, ElapsedSteps{2});
  EXPECT_EQ(tracker.pose().translation().x(), 1.1);
  EXPECT_LT((tracker.pose().linear() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

}  // namespace
}  // namespace mrroc
