#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "vsp/fakes.hpp"

namespace mrroc::vsp::sampler_laws_test {
namespace {

/// A request of a client at `arrival`.
struct Asked {
  Tick arrival = 0;
  Tick measure_at = 0;
  Caller caller;

  Tick due() const { return std::max(arrival, measure_at); }
};

constexpr Tick kEnd = 120;

std::vector<Asked> asked_by_clients() {
  std::vector<Asked> all;
  const std::size_t clients = *rc::gen::inRange<std::size_t>(1, 5);
  const int count = *rc::gen::inRange(0, 40);
  std::map<std::size_t, std::uint64_t> sequence;
  for (int i = 0; i < count; ++i) {
    const std::size_t client = *rc::gen::inRange<std::size_t>(0, clients);
    all.push_back({*rc::gen::inRange<Tick>(0, 100), *rc::gen::inRange<Tick>(0, kEnd), {client, 0}});
  }
  std::stable_sort(all.begin(), all.end(), [](const Asked& a, const Asked& b) { return a.arrival < b.arrival; });
  for (Asked& asked : all) asked.caller.sequence = ++sequence[asked.caller.client];
  return all;
}

/// Runs a sampler like a VSP process: it wakes when mail arrives, at `next_wake`, and, with `every_tick`, always.
std::vector<Given> run(const std::vector<Asked>& all, Tick period, bool continuous, bool every_tick) {
  FakeSource source;
  FakeSensor sensor;
  sensor.is_continuous = continuous;
  RecordingSink sink;
  Sampler sampler(sensor, source, period);
  auto next = all.begin();
  for (Tick now = 0; now <= kEnd; ++now) {
    bool mail = false;
    sink.now = now;
    for (; next != all.end() && next->arrival == now; ++next) {
      sampler.on_request(next->caller, {SensorRequestKind::reading, next->measure_at}, now, sink);
      mail = true;
    }
    if (every_tick || mail || sampler.next_wake() <= now) sampler.on_tick(now, sink);
  }
  return sink.given;
}

TEST(SamplerLaws, EveryRequestIsAnsweredOnceAtItsTickInOrder) {
  EXPECT_TRUE(rc::check([] {
    std::vector<Asked> expected = asked_by_clients();
    const std::vector<Given> given = run(expected, 0, *rc::gen::arbitrary<bool>(), false);
    std::stable_sort(expected.begin(), expected.end(),
                     [](const Asked& a, const Asked& b) { return a.due() < b.due(); });
    RC_ASSERT(given.size() == expected.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      RC_ASSERT(given[i].reply);
      RC_ASSERT(given[i].caller.client == expected[i].caller.client);
      RC_ASSERT(given[i].caller.sequence == expected[i].caller.sequence);
      RC_ASSERT(given[i].at == expected[i].due());
      RC_ASSERT(given[i].reading.tick == expected[i].due());
      RC_ASSERT(given[i].reading.values[0] == static_cast<double>(expected[i].due()));
    }
  }));
}

TEST(SamplerLaws, PublicationsAreAtEveryMultipleOfThePeriodForAnyRequests) {
  EXPECT_TRUE(rc::check([] {
    const Tick period = *rc::gen::inRange<Tick>(1, 30);
    Tick expected = 0;
    for (const Given& given : run(asked_by_clients(), period, *rc::gen::arbitrary<bool>(), false)) {
      if (given.reply) continue;
      RC_ASSERT(given.at == expected);
      RC_ASSERT(given.reading.tick == expected);
      expected += period;
    }
    RC_ASSERT(expected > kEnd);
  }));
}

TEST(SamplerLaws, WakingAtEveryTickChangesNothing) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Asked> all = asked_by_clients();
    const Tick period = *rc::gen::inRange<Tick>(0, 30);
    const bool continuous = *rc::gen::arbitrary<bool>();
    const std::vector<Given> sparse = run(all, period, continuous, false);
    const std::vector<Given> dense = run(all, period, continuous, true);
    RC_ASSERT(sparse.size() == dense.size());
    for (std::size_t i = 0; i < sparse.size(); ++i) {
      RC_ASSERT(sparse[i].at == dense[i].at);
      RC_ASSERT(sparse[i].reply == dense[i].reply);
      RC_ASSERT(sparse[i].caller.client == dense[i].caller.client);
      RC_ASSERT(sparse[i].reading.sequence == dense[i].reading.sequence);
      RC_ASSERT(sparse[i].reading.values[0] == dense[i].reading.values[0]);
    }
  }));
}

}  // namespace
}  // namespace mrroc::vsp::sampler_laws_test
