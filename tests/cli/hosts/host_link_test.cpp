#include "cli/hosts/host_link.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <memory>

#include "cli/processes/addresses.hpp"

namespace mrroc::cli::host_link_test {
namespace {

constexpr int kDomain = 90;
constexpr int kPatience = 20000;  // ms

RC_GTEST_PROP(Heartbeat, OpensAsItWasSealed,
              (bool from_runner, std::uint64_t sequence, std::int64_t sent, std::int64_t echo, std::int64_t held,
               std::uint32_t presses, std::uint32_t resets)) {
  const HeartbeatKey key = new_beat_key();
  const auto datagram = seal({from_runner, sequence, sent, echo, held, presses, resets}, key);
  const auto beat = open(datagram.data(), datagram.size(), key);
  RC_ASSERT(beat.has_value());
  RC_ASSERT(beat->from_runner == from_runner && beat->sequence == sequence && beat->sent == sent);
  RC_ASSERT(beat->echo == echo && beat->held == held);
  RC_ASSERT(beat->presses == presses && beat->resets == resets);
}

RC_GTEST_PROP(Heartbeat, RejectsAFlippedBit, (std::uint64_t sequence)) {
  const HeartbeatKey key = new_beat_key();
  auto datagram = seal({true, sequence, 1, 2, 3}, key);
  const auto bit = *rc::gen::inRange<std::size_t>(0, 8 * datagram.size());
  datagram[bit / 8] = static_cast<std::uint8_t>(datagram[bit / 8] ^ (1U << (bit % 8)));
  RC_ASSERT(!open(datagram.data(), datagram.size(), key));
}

RC_GTEST_PROP(Heartbeat, RejectsRandomBytes, (std::vector<std::uint8_t> bytes)) {
  RC_ASSERT(!open(bytes.data(), bytes.size(), new_beat_key()));
}

TEST(Heartbeat, RejectsAnotherKey) {
  const auto datagram = seal({true, 1, 2, 3, 4}, new_beat_key());
  EXPECT_FALSE(open(datagram.data(), datagram.size(), new_beat_key()));
  EXPECT_FALSE(open(datagram.data(), datagram.size() - 1, new_beat_key()));
}

TEST(Heartbeat, KeyIsSentInHexadecimal) {
  const HeartbeatKey key = new_beat_key();
  EXPECT_EQ(key_of_hex(to_hex(key)), key);
  EXPECT_FALSE(key_of_hex(to_hex(key) + "0"));
  EXPECT_FALSE(key_of_hex(std::string(64, 'g')));
}

bool readable(int fd, int milliseconds) {
  pollfd descriptor{fd, POLLIN, 0};
  return poll(&descriptor, 1, milliseconds) == 1;
}

TEST(HostLink, LearnsThePeersClock) {
  const in_addr here = ipv4_of("127.0.0.1");
  clock::EmergencyStop nobodys;
  const HeartbeatKey key = new_beat_key();
  HostLink a(here, kDomain, key, true, 0.05, nobodys);
  HostLink b(here, kDomain, key, false, 0.05, nobodys);
  EXPECT_NE(a.port(), b.port());
  a.start(here, b.port());
  b.start(here, a.port());
  for (const HostLink* link : {&a, &b}) {
    for (int look = 0; look < kPatience && !link->offset(); ++look) poll(nullptr, 0, 1);
    ASSERT_TRUE(link->offset());
    EXPECT_LE(std::abs(link->offset()->ns), link->offset()->error_ns) << "both use the same clock";
  }
  EXPECT_FALSE(a.lost());
}

TEST(HostLink, ReportsSilenceOnceItIsWatched) {
  const in_addr here = ipv4_of("127.0.0.1");
  clock::EmergencyStop nobodys;
  const HeartbeatKey key = new_beat_key();
  HostLink a(here, kDomain, key, true, 0.2, nobodys);
  auto b = std::make_unique<HostLink>(here, kDomain, key, false, 0.2, nobodys);
  a.start(here, b->port());
  EXPECT_FALSE(readable(a.event_fd(), 500)) << "it is not watched yet";
  b->start(here, a.port());
  for (int look = 0; look < kPatience && a.figures().heard == 0; ++look) poll(nullptr, 0, 1);
  a.watch();
  EXPECT_FALSE(a.lost());
  b.reset();
  ASSERT_TRUE(readable(a.event_fd(), kPatience));
  EXPECT_TRUE(a.lost());
  EXPECT_GE(a.figures().longest_silence, 200'000'000);
}

TEST(HostLink, IsNotKeptAliveByAnotherKey) {
  const in_addr here = ipv4_of("127.0.0.1");
  clock::EmergencyStop nobodys;
  HostLink a(here, kDomain, new_beat_key(), true, 0.2, nobodys);
  HostLink unknown(here, kDomain, new_beat_key(), false, 0.2, nobodys);
  a.start(here, unknown.port());
  unknown.start(here, a.port());
  a.watch();
  ASSERT_TRUE(readable(a.event_fd(), kPatience));
  EXPECT_EQ(a.figures().heard, 0U);
  EXPECT_GT(a.figures().refused, 0U);
  EXPECT_FALSE(a.offset());
}

TEST(HostLink, TransmitsTheEmergencyStopOfTheRunner) {
  const in_addr here = ipv4_of("127.0.0.1");
  const HeartbeatKey key = new_beat_key();
  clock::EmergencyStop runners, agents;
  HostLink runner(here, kDomain, key, true, 0.2, runners);
  HostLink agent(here, kDomain, key, false, 0.2, agents);
  runners.press();
  runner.start(here, agent.port());
  agent.start(here, runner.port());
  const auto await = [&](std::uint32_t presses, std::uint32_t resets) {
    for (int look = 0; look < kPatience && (agents.presses() < presses || agents.resets() < resets); ++look)
      poll(nullptr, 0, 1);
    EXPECT_EQ(agents.presses(), presses);
    EXPECT_EQ(agents.resets(), resets);
  };
  await(1, 0);  // also a stop from before the first heartbeat
  runners.reset();
  await(1, 1);
  runners.press();
  runners.press();
  await(3, 1);
  agents.press();
  const auto heard = runner.figures().heard;
  for (int look = 0; look < kPatience && runner.figures().heard < heard + 3; ++look) poll(nullptr, 0, 1);
  EXPECT_EQ(runners.presses(), 3U) << "an agent has no operator";
}

}  // namespace
}  // namespace mrroc::cli::host_link_test
