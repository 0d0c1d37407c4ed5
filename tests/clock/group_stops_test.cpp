#include "clock/group_stops.hpp"

#include <gtest/gtest.h>

namespace mrroc::clock::group_stops_test {
namespace {

TEST(GroupStops, CountFromTheTickAfter) {
  GroupStops stops;
  EXPECT_FALSE(stops.has_stopped(5, 100));
  stops.announce(3, 5, 40);
  EXPECT_FALSE(stops.has_stopped(5, 40));
  EXPECT_TRUE(stops.has_stopped(5, 41));
  EXPECT_FALSE(stops.has_stopped(6, 41));
}

TEST(GroupStops, TheFirstOneOfAMotionCounts) {
  GroupStops stops;
  stops.announce(0, 5, 40);
  stops.announce(0, 5, 60);
  EXPECT_TRUE(stops.has_stopped(5, 41));
  stops.announce(1, 5, 50);
  EXPECT_TRUE(stops.has_stopped(5, 41));
}

TEST(GroupStops, ALaterMotionReplacesAnEarlierOne) {
  GroupStops stops;
  stops.announce(63, 5, 40);
  stops.announce(63, 8, 90);
  EXPECT_FALSE(stops.has_stopped(5, 100));
  EXPECT_FALSE(stops.has_stopped(8, 90));
  EXPECT_TRUE(stops.has_stopped(8, 91));
}

TEST(GroupStops, RobotsBeyondTheTableStopAlone) {
  GroupStops stops;
  stops.announce(GroupStops::kMaxRobots, 5, 40);
  EXPECT_FALSE(stops.has_stopped(5, 41));
}

}  // namespace
}  // namespace mrroc::clock::group_stops_test
