#include <gtest/gtest.h>

#include "allocations.hpp"
#include "vsp/fakes.hpp"

namespace mrroc::vsp::allocation_test {
namespace {

class CountingSink : public ReadingSink {
 public:
  void reply(const Caller& /*caller*/, const SensorReading& /*reading*/) override { ++given; }
  void publish(const SensorReading& /*reading*/) override { ++given; }
  int given = 0;
};

TEST(Allocation, CounterCounts) {
  const std::size_t before = test::thread_allocations();
  ::operator delete(::operator new(8));
  EXPECT_EQ(test::thread_allocations() - before, 1U);
}

TEST(Allocation, SamplerDoesNotAllocateAfterItsConstruction) {
  FakeSource source;
  FakeSensor sensor;
  sensor.is_continuous = true;
  CountingSink sink;
  Sampler sampler(sensor, source, 3);
  const std::size_t before = test::thread_allocations();
  for (Tick now = 0; now < 100; ++now) {
    source.bad = now % 7 == 0;
    source.state = now % 11 == 0 ? SourceState::silent : SourceState::ready;
    for (std::size_t client = 0; client < 3; ++client) {
      const SensorRequestKind kind = client == 2 ? SensorRequestKind::bias : SensorRequestKind::reading;
      sampler.on_request({client, now}, {kind, now + client}, now, sink);
    }
    sampler.on_tick(now, sink);
  }
  for (std::size_t client = 0; client <= Sampler::kMaxPending; ++client) {
    sampler.on_request({client, 100}, {SensorRequestKind::reading, 1000}, 100, sink);
  }
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_GT(sink.given, 300);
}

}  // namespace
}  // namespace mrroc::vsp::allocation_test
