// The links under the real clocks: one ECP in this process, its EDP in another one.

#include <fcntl.h>
#include <gtest/gtest.h>

#include <thread>

#include "clock/host.hpp"
#include "clock/participant.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/peer_process.hpp"
#include "links/test_domain.hpp"

namespace mrroc::links {
namespace {

/// Ticks at which the EDP answered, and at which the ECP received the answer.
using Trace = std::vector<std::pair<Tick, Tick>>;

Trace run(clock::Mode mode, int exchanges) {
  clock::ClockHost host({.mode = mode, .period = 0.002, .participants = {"ecp", "edp"}, .live_operator = true});
  FreeDomain number;
  ::fcntl(host.fd(), F_SETFD, 0);  // for the peer, under the same number
  // children first: they would inherit the domain's sockets
  PeerProcess edp("lockstep", number.id(), "t/arm", 20, std::to_string(host.fd()));
  Domain domain({.id = number.id(), .lease = 20});
  Trace trace;
  std::thread ecp([&] {
    const auto clock = clock::attach_clock(host.fd(), "ecp");
    RobotRequester link(domain, *clock, "t/arm", "arm_edp", 100000);
    link.connect(kPatience);
    ASSERT_TRUE(clock->start());
    RobotState state;
    RobotCommand command;
    for (int i = 0; i < exchanges; ++i) {
      command.joints = JointVector::Constant(1, i);
      link.send(command);
      link.receive(state);
      EXPECT_EQ(state.joints[0], i);
      trace.emplace_back(state.tick, clock->tick());
    }
  });
  EXPECT_TRUE(host.wait_ready(kPatience).empty());
  host.start();
  ecp.join();
  EXPECT_EQ(host.error(), "");
  host.end();
  return trace;
}

TEST(Lockstep, AnswerHasItsTickAndArrivesInIt) {
  Trace expected;
  for (Tick i = 1; i <= 200; ++i) expected.emplace_back(3 * i, 3 * i);
  for (int round = 0; round < 3; ++round) EXPECT_EQ(run(clock::Mode::lockstep, 200), expected);
}

TEST(Lockstep, SameLinksWorkInRealTime) {
  const Trace trace = run(clock::Mode::real, 20);
  ASSERT_EQ(trace.size(), 20U);
  for (std::size_t i = 1; i < trace.size(); ++i) EXPECT_GE(trace[i].first, trace[i - 1].first + 3);
}

}  // namespace
}  // namespace mrroc::links
