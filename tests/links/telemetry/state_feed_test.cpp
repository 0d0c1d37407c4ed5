#include "links/telemetry/state_feed.hpp"

#include <gtest/gtest.h>

#include "links/code_of.hpp"
#include "links/telemetry/state_follower.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"

namespace mrroc::links {
namespace {

TEST(StateFeed, CarriesEveryStateInOrder) {
  TestDomain net;
  TestClock clock;
  StateFeed edp(net.domain, clock, "t/arm", "wrist");
  StateFollower vsp(net.domain, clock, "t/arm", "wrist", "arm_edp");
  vsp.connect(kPatience);
  RobotState state;
  EXPECT_FALSE(vsp.take(state)) << "pongs are not states";
  for (Tick k = 1; k <= 50; ++k) {
    state.tick = k;
    state.joints = JointVector::Constant(6, static_cast<double>(k));
    edp.send(state);
  }
  for (Tick k = 1; k <= 50; ++k) {
    ASSERT_TRUE(vsp.take(state));
    EXPECT_EQ(state.tick, k);
    EXPECT_EQ(state.joints[5], static_cast<double>(k));
  }
  EXPECT_FALSE(vsp.take(state));
  EXPECT_EQ(clock.in_flight.load(), 0);
}

TEST(StateFeed, SilentRobotIsNamed) {
  TestDomain net;
  TestClock clock;
  StateFollower vsp(net.domain, clock, "t/arm", "wrist", "arm_edp");
  EXPECT_EQ(code_of([&] { vsp.connect(0.1); }, "arm_edp does not answer: nothing on topic t/arm/wrist/state"),
            ErrorCode::link_lost);
}

}  // namespace
}  // namespace mrroc::links
