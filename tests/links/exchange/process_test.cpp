// Behaviour when the process at the other end is stopped, killed or restarted.

#include <gtest/gtest.h>

#include <thread>

#include "links/exchange/connect.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "links/peer_process.hpp"
#include "links/telemetry/status_collector.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

TEST(Process, KilledPeerIsNamed) {
  TestDomain net;
  TestClock clock;
  PeerProcess peer("respond", net.domain.id(), "t/arm", 1.5);
  RobotRequester link(net.domain, clock, "t/arm", "arm_edp", 1000000);
  link.connect(kPatience);
  RobotState state;
  link.send({});
  link.receive(state);
  peer.kill();
  link.send({});
  try {
    link.receive(state);
    FAIL() << "a dead process has answered";
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::process_died);
    EXPECT_EQ(error.detail(), "arm_edp is gone from topic t/arm/state");
  }
}

TEST(Process, RestartedPeerIsAnotherOne) {
  TestDomain net;
  TestClock clock;
  Writer<RobotCommand> writer(net.domain, clock, "t/arm/command");
  Reader<RobotState> reader(net.domain, clock, "t/arm/state");
  std::uint64_t first = 0;
  {
    const PeerProcess peer("respond", net.domain.id(), "t/arm");
    connect(writer, {&reader}, kPatience, "peer");
    first = reader.ponged();
  }
  const PeerProcess peer("respond", net.domain.id(), "t/arm");
  connect(writer, {&reader}, kPatience, "peer");
  EXPECT_NE(reader.ponged(), first);
  EXPECT_NE(first, 0U);
}

TEST(Process, CommandsQueuedWhileAProcessWasStoppedHaveNoEffect) {
  TestDomain net;
  TestClock clock;
  PeerProcess peer("cautious", net.domain.id(), "t/arm");
  Writer<RobotCommand> writer(net.domain, clock, "t/arm/command");
  Reader<RobotState> reader(net.domain, clock, "t/arm/state", {.depth = 4096});
  connect(writer, {&reader}, kPatience, "peer");

  std::vector<std::int64_t> sent_ns{0};  // by sequence: lower bound of its stamp
  const auto send_for = [&](int messages) {
    for (int i = 0; i < messages; ++i) {
      writer.write({}, sent_ns.size());
      sent_ns.push_back(clock::monotonic_ns());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  };
  send_for(50);
  peer.stop();
  const std::uint64_t first_stopped = sent_ns.size();
  send_for(250);
  const std::int64_t continued_ns = clock::monotonic_ns();
  const std::uint64_t first_continued = sent_ns.size();
  peer.go_on();

  // continues until a command from after the pause has been executed
  const auto max_age_ns = static_cast<std::int64_t>(RobotResponder::kMaxAge * 1e9);
  std::uint64_t newest = 0;
  std::uint32_t stale = 0;
  EXPECT_TRUE(eventually([&] {
    send_for(1);
    RobotState state;
    Header header;
    while (reader.take(state, header)) {
      newest = header.sequence;
      stale = state.late_commands;
      if (header.sequence < first_stopped) continue;
      EXPECT_GE(sent_ns[header.sequence] + max_age_ns, continued_ns) << "command " << header.sequence << " was too old";
    }
    return newest >= first_continued;
  }));
  EXPECT_GT(stale, 0U);
}

TEST(Process, TelemetryReportsAnEndedProcess) {
  TestDomain net;
  StatusCollector collector(net.domain, "t");
  PeerProcess peer("status", net.domain.id(), "t", 1);
  const std::string name = "process" + std::to_string(peer.pid());
  const auto alive = [&] {
    collector.poll();
    const auto found = collector.processes().find(name);
    return found == collector.processes().end() ? -1 : static_cast<int>(found->second.alive);
  };
  EXPECT_TRUE(eventually([&] { return alive() == 1; }));
  peer.kill();
  EXPECT_TRUE(eventually([&] { return alive() == 0; }));
  EXPECT_EQ(collector.processes().at(name).status.pid, std::stoi(name.substr(7))) << "its last status remains";
}

}  // namespace
}  // namespace mrroc::links
