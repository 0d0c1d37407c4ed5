#include <gtest/gtest.h>

#include "links/code_of.hpp"
#include "links/exchange/sensor_requester.hpp"
#include "links/exchange/sensor_responder.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"

namespace mrroc::links {
namespace {

struct SensorPair {
  explicit SensorPair(bool published, bool simulated = false)
      : clock(simulated),
        vsp(net.domain, clock, "t/wrist", {"arm", "mp"}, published),
        arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.published = published}),
        mp(net.domain, clock, "t/wrist", "mp", "wrist_vsp", {.published = published}) {
    arm.connect(kPatience);
    mp.connect(kPatience);
  }

  TestDomain net;
  TestClock clock;
  SensorResponder vsp;
  SensorRequester arm;
  SensorRequester mp;
  SensorRequest request;
  SensorReading reading;
  Caller caller;
};

TEST(SensorLink, AnswersEachClientItsOwnRequest) {
  SensorPair pair(false);
  EXPECT_FALSE(pair.vsp.take(pair.request, pair.caller));
  pair.mp.request({SensorRequestKind::bias, 7});
  pair.arm.request({SensorRequestKind::reading, 8});
  SensorReading reading;
  reading.channel_count = 1;
  ASSERT_TRUE(pair.vsp.take(pair.request, pair.caller));
  EXPECT_EQ(pair.caller.client, 0U) << "clients are served in the given order";
  EXPECT_EQ(pair.request.measure_at, 8U);
  reading.values[0] = 1.5;
  EXPECT_TRUE(pair.vsp.reply(reading, pair.caller));
  ASSERT_TRUE(pair.vsp.take(pair.request, pair.caller));
  EXPECT_EQ(pair.caller.client, 1U);
  EXPECT_EQ(pair.request.kind, SensorRequestKind::bias);
  reading.values[0] = 2.5;
  EXPECT_TRUE(pair.vsp.reply(reading, pair.caller));
  EXPECT_FALSE(pair.vsp.take(pair.request, pair.caller));
  pair.arm.receive(pair.reading);
  EXPECT_EQ(pair.reading.values[0], 1.5);
  pair.mp.receive(pair.reading);
  EXPECT_EQ(pair.reading.values[0], 2.5);
  EXPECT_FALSE(pair.arm.latest(pair.reading)) << "nothing is published";
  EXPECT_THROW(pair.vsp.publish(reading), SystemError);
}

TEST(SensorLink, PublishesToAllWhoReadIt) {
  SensorPair pair(true);
  EXPECT_FALSE(pair.arm.latest(pair.reading));
  SensorReading reading;
  for (reading.sequence = 1; reading.sequence <= 50; ++reading.sequence) pair.vsp.publish(reading);
  for (SensorRequester* client : {&pair.arm, &pair.mp}) {
    for (int i = 0; i < 2; ++i) {
      pair.reading.sequence = 0;
      ASSERT_TRUE(client->latest(pair.reading));
      EXPECT_EQ(pair.reading.sequence, 50U);
    }
  }
}

TEST(SensorLink, PublishedReadingIsAwaitedOnceWithATimeout) {
  SensorPair pair(true);
  EXPECT_FALSE(pair.arm.await_published(0)) << "the timeout is over without a reading";
  pair.vsp.publish(SensorReading{});
  EXPECT_TRUE(pair.arm.await_published(0));
  EXPECT_TRUE(pair.arm.await_published(0)) << "it stays";
  SensorPair silent(false);
  EXPECT_FALSE(silent.arm.await_published(kNever)) << "it publishes nothing";
}

TEST(SensorLink, ConnectsAlsoToThePublishedReadings) {
  TestDomain net;
  TestClock clock;
  SensorResponder vsp(net.domain, clock, "t/wrist", {"arm"}, false);
  SensorRequester arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.published = true});
  EXPECT_EQ(code_of([&] { arm.connect(0.1); }, "wrist_vsp does not answer: nothing on topic t/wrist/published"),
            ErrorCode::link_lost);
}

TEST(SensorLink, SilenceIsAnErrorInRealTime) {
  TestDomain net;
  TestClock clock;
  SensorResponder vsp(net.domain, clock, "t/wrist", {"arm"}, false);
  SensorRequester arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.timeout = 10});
  arm.connect(kPatience);
  arm.request({});
  SensorReading reading;
  EXPECT_EQ(code_of([&] { arm.receive(reading); }, "wrist_vsp has not answered"), ErrorCode::process_silent);
}

}  // namespace
}  // namespace mrroc::links
