// The state e_l of the robot that carries a sensor: f_v receives that of the raw reading's own tick, or none.
#include <gtest/gtest.h>

#include "vsp/fakes.hpp"

namespace mrroc::vsp::sampler_effector_test {
namespace {

/// v = r minus the tick of e_l: 0 when both have the same tick.
class DifferenceSensor : public FakeSensor {
 public:
  void effector_state(const RobotState& e) noexcept override { tick_ = e.tick; }
  void aggregate(const RawReading& r, SensorReading& v) noexcept override {
    v.values[0] = r.values[0] - static_cast<double>(tick_);
  }

 private:
  Tick tick_ = 0;
};

/// The newest reading is `age` ticks old.
class OldSource : public FakeSource {
 public:
  SourceState read(Tick wanted, RawReading& raw) noexcept override { return FakeSource::read(wanted - age, raw); }
  Tick age = 0;
};

class SamplerEffector : public ::testing::Test {
 protected:
  void state(Tick tick) {
    RobotState e;
    e.tick = tick;
    sampler.on_effector_state(e);
  }
  void request(Tick at) { sampler.on_request({0, ++requests_}, {SensorRequestKind::reading, at}, at, sink); }
  void tick(Tick now) {
    sink.now = now;
    sampler.on_tick(now, sink);
  }
  OldSource source;
  DifferenceSensor sensor;
  RecordingSink sink;
  Sampler sampler{sensor, source, 0, true};

 private:
  std::uint64_t requests_ = 0;
};

TEST_F(SamplerEffector, DueReadingWaitsForTheStateOfItsTick) {
  state(9);
  request(10);
  tick(10);
  EXPECT_TRUE(sink.given.empty());
  EXPECT_EQ(source.reads, 0) << "the hardware is read when the state is there";
  state(10);
  tick(10);
  ASSERT_EQ(sink.given.size(), 1U);
  EXPECT_EQ(sink.given[0].reading.error.code, ErrorCode::none);
  EXPECT_EQ(sink.given[0].reading.values[0], 0);
  EXPECT_EQ(sampler.next_wake(), kNever);
}

TEST_F(SamplerEffector, ReadingOfAnEarlierTickGetsTheStateOfThatTick) {
  for (Tick k = 1; k <= 200; ++k) state(k);
  for (const Tick age : {Tick{0}, Tick{1}, Tick{40}}) {
    source.age = age;
    request(200);
    tick(200);
    EXPECT_EQ(sink.given.back().reading.tick, 200 - age);
    EXPECT_EQ(sink.given.back().reading.values[0], 0) << age;
  }
}

TEST_F(SamplerEffector, PreviousStateReplacesAMissedTick) {
  state(10);
  state(13);
  source.age = 1;
  request(13);
  tick(13);
  ASSERT_EQ(sink.given.size(), 1U);
  EXPECT_EQ(sink.given[0].reading.values[0], 2) << "12 beside 10";
}

TEST_F(SamplerEffector, IsNotReadyAfterATimeoutWithoutAState) {
  state(10);
  request(20);
  tick(20);
  EXPECT_EQ(sampler.next_wake(), 20 + Sampler::kStateLate);
  tick(20 + Sampler::kStateLate - 1);
  EXPECT_TRUE(sink.given.empty());
  tick(20 + Sampler::kStateLate);
  ASSERT_EQ(sink.given.size(), 1U);
  EXPECT_EQ(sink.given[0].reading.error.code, ErrorCode::sensor_not_ready);
  state(100);
  request(100);
  tick(100);
  ASSERT_EQ(sink.given.size(), 2U);
  EXPECT_EQ(sink.given[1].reading.error.code, ErrorCode::none) << "the next reading is judged on its own";
}

}  // namespace
}  // namespace mrroc::vsp::sampler_effector_test
