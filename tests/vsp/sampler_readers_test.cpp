#include <gtest/gtest.h>

#include <latch>
#include <thread>

#include "core/lockfree/shared_slot.hpp"
#include "vsp/fakes.hpp"

namespace mrroc::vsp::sampler_readers_test {
namespace {

/// An aggregation that does not end before the reader has read, from its second call on.
class SlowSensor : public FakeSensor {
 public:
  void aggregate(const RawReading& r, SensorReading& v) noexcept override {
    if (++calls_ > 1) {
      begun.count_down();
      may_end.wait();
    }
    FakeSensor::aggregate(r, v);
  }
  std::latch begun{1};
  std::latch may_end{1};

 private:
  int calls_ = 0;
};

class BufferSink : public ReadingSink {
 public:
  void reply(const Caller& /*caller*/, const SensorReading& /*reading*/) override {}
  void publish(const SensorReading& reading) override { buffer.store(reading); }
  core::SharedSlot<SensorReading> buffer;
};

// The original's non-interactive VSP held a lock during its aggregation: a reader waited for its end.
TEST(SamplerReaders, ReadTheLatestReadingDuringAnAggregation) {
  SlowSensor sensor;
  FakeSource source;
  BufferSink sink;
  Sampler sampler(sensor, source, 1);
  std::thread vsp([&] {
    sampler.on_tick(0, sink);
    sampler.on_tick(1, sink);
  });
  sensor.begun.wait();
  SensorReading latest;
  const bool there = sink.buffer.load(latest);  // would hang here if the reader waited for the aggregation
  sensor.may_end.count_down();
  vsp.join();
  ASSERT_TRUE(there);
  EXPECT_EQ(latest.tick, 0U);
  ASSERT_TRUE(sink.buffer.load(latest));
  EXPECT_EQ(latest.tick, 1U);
}

}  // namespace
}  // namespace mrroc::vsp::sampler_readers_test
