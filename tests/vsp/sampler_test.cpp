#include "vsp/sampler.hpp"

#include <gtest/gtest.h>

#include "mrroc/errors.hpp"
#include "vsp/fakes.hpp"

namespace mrroc::vsp::sampler_test {
namespace {

class SamplerTest : public ::testing::Test {
 protected:
  void request(std::size_t client, SensorRequest request, Tick now) {
    sink.now = now;
    sampler.on_request({client, ++requests_}, request, now, sink);
  }
  void tick(Sampler& which, Tick now) {
    sink.now = now;
    which.on_tick(now, sink);
  }
  void tick(Tick now) { tick(sampler, now); }

  FakeSource source;
  FakeSensor sensor;
  RecordingSink sink;
  Sampler sampler{sensor, source, 0};

 private:
  std::uint64_t requests_ = 0;
};

TEST_F(SamplerTest, AnswersARequestAtItsTickWithThatTicksReading) {
  request(0, {SensorRequestKind::reading, 12}, 5);
  EXPECT_EQ(sampler.next_wake(), 12U);
  tick(5);
  tick(11);
  EXPECT_TRUE(sink.given.empty());
  EXPECT_EQ(source.reads, 0);  // no measurement before its tick
  tick(12);
  ASSERT_EQ(sink.given.size(), 1U);
  const SensorReading& reading = sink.given[0].reading;
  EXPECT_EQ(reading.sequence, 1U);
  EXPECT_EQ(reading.tick, 12U);
  EXPECT_EQ(reading.channel_count, 1U);
  EXPECT_EQ(reading.values[0], 12);
  EXPECT_EQ(reading.error.error_class, ErrorClass::none);
  EXPECT_EQ(sampler.next_wake(), kNever);
}

TEST_F(SamplerTest, AnswersDueOrLateRequestsAtOnce) {
  request(0, {SensorRequestKind::reading, 0}, 5);
  request(1, {SensorRequestKind::reading, 5}, 5);
  EXPECT_LE(sampler.next_wake(), 5U);
  tick(5);
  ASSERT_EQ(sink.given.size(), 2U);
  EXPECT_EQ(sink.given[0].reading.tick, 5U);  // the present reading, not a past one
}

TEST_F(SamplerTest, AllRequestsOfATickGetTheSameReading) {
  for (std::size_t client = 0; client < 3; ++client) request(client, {SensorRequestKind::reading, 7}, 1);
  tick(7);
  ASSERT_EQ(sink.given.size(), 3U);
  EXPECT_EQ(source.reads, 1);
  EXPECT_EQ(sensor.aggregations, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(sink.given[i].caller.client, i);
    EXPECT_EQ(sink.given[i].reading.sequence, 1U);
  }
}

TEST_F(SamplerTest, BiasIsExecutedInTheOrderOfRequests) {
  request(0, {SensorRequestKind::reading, 0}, 9);
  request(1, {SensorRequestKind::bias, 0}, 9);
  request(2, {SensorRequestKind::reading, 0}, 9);
  tick(9);
  ASSERT_EQ(sink.given.size(), 3U);
  EXPECT_EQ(sink.given[0].reading.values[0], 9);
  EXPECT_EQ(sink.given[1].reading.values[0], 0);
  EXPECT_EQ(sink.given[2].reading.values[0], 0);
  EXPECT_EQ(sink.given[0].reading.sequence, 1U);
  EXPECT_EQ(sink.given[1].reading.sequence, 2U);
  EXPECT_EQ(sink.given[2].reading.sequence, 2U);
}

TEST_F(SamplerTest, ReportsAMissingZeroOnlyToItsCaller) {
  sensor.can_bias = false;
  request(0, {SensorRequestKind::bias, 0}, 9);
  request(1, {SensorRequestKind::reading, 0}, 9);
  tick(9);
  ASSERT_EQ(sink.given.size(), 2U);
  EXPECT_EQ(sink.given[0].reading.error.error_class, ErrorClass::non_fatal);
  EXPECT_EQ(sink.given[0].reading.error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(sink.given[1].reading.error.error_class, ErrorClass::none);
  EXPECT_EQ(sink.given[1].reading.values[0], 9);
}

TEST_F(SamplerTest, AnswersExcessRequestAtOnceWithBusy) {
  for (std::size_t client = 0; client < Sampler::kMaxPending; ++client) {
    request(client, {SensorRequestKind::reading, 100}, 1);
  }
  EXPECT_TRUE(sink.given.empty());
  request(99, {SensorRequestKind::reading, 100}, 1);
  ASSERT_EQ(sink.given.size(), 1U);
  EXPECT_EQ(sink.given[0].caller.client, 99U);
  EXPECT_EQ(sink.given[0].reading.error.code, ErrorCode::busy);
  tick(100);
  EXPECT_EQ(sink.given.size(), 1U + Sampler::kMaxPending);
}

TEST_F(SamplerTest, PublishesOnAFixedGrid) {
  Sampler publisher(sensor, source, 10);
  EXPECT_EQ(publisher.next_wake(), 0U);
  for (const Tick now : {0U, 5U, 10U, 13U, 47U, 50U, 60U}) tick(publisher, now);
  std::vector<Tick> at;
  for (const Given& given : sink.given) at.push_back(given.at);
  EXPECT_EQ(at, (std::vector<Tick>{0, 10, 47, 50, 60}));  // 20 came at 47; 30 and 40 were missed
  EXPECT_EQ(publisher.missed(), 2U);
  EXPECT_EQ(publisher.next_wake(), 70U);
}

TEST_F(SamplerTest, FeedsAContinuousSensorEveryTickOnceBeforeItAggregates) {
  sensor.is_continuous = true;
  Sampler filter(sensor, source, 4);
  for (Tick now = 0; now < 10; ++now) {
    EXPECT_EQ(filter.next_wake(), now);
    tick(filter, now);
    tick(filter, now);
  }
  EXPECT_EQ(std::vector<Tick>(sensor.tracked.begin(), sensor.tracked.begin() + 10),
            (std::vector<Tick>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(sensor.tracked_count, 10U);
  EXPECT_EQ(sink.given.size(), 3U);
}

TEST(PublicationPeriod, IsAWholeNumberOfServoPeriods) {
  config::SensorEntry entry;
  entry.name = "gate";
  EXPECT_EQ(publication_period(entry, 0.002), 0U);
  entry.interactive = false;
  entry.rate = 500;
  EXPECT_EQ(publication_period(entry, 0.002), 1U);
  entry.rate = 166.667;
  EXPECT_EQ(publication_period(entry, 0.002), 3U);
  entry.rate = 1;
  EXPECT_EQ(publication_period(entry, 0.001), 1000U);
  for (const double rate : {0.0, -5.0, 300.0, 600.0, 1e-323, 1e-30}) {
    entry.rate = rate;
    EXPECT_THROW(publication_period(entry, 0.002), SystemError) << rate;
  }
}

}  // namespace
}  // namespace mrroc::vsp::sampler_test
