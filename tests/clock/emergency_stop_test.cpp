#include <gtest/gtest.h>

#include "clock/host.hpp"
#include "clock/participant.hpp"

namespace mrroc::clock::emergency_stop_test {
namespace {

TEST(EmergencyStop, IsSeenByEveryClockOfTheDeploymentAtOnce) {
  HostOptions options;
  options.participants = {"a", "b"};
  ClockHost host(options);
  const auto operator_clock = host.operator_clock();
  const auto a = attach_clock(host.fd(), "a");
  const auto b = attach_clock(host.fd(), "b");
  for (Clock* clock : {operator_clock.get(), a.get(), b.get()}) {
    EXPECT_EQ(clock->emergency_stop().presses(), 0U);
    EXPECT_EQ(clock->emergency_stop().resets(), 0U);
  }
  operator_clock->emergency_stop().press();
  b->emergency_stop().press();
  operator_clock->emergency_stop().reset();
  for (Clock* clock : {operator_clock.get(), a.get(), b.get()}) {
    EXPECT_EQ(clock->emergency_stop().presses(), 2U);
    EXPECT_EQ(clock->emergency_stop().resets(), 1U);
  }
}

}  // namespace
}  // namespace mrroc::clock::emergency_stop_test
