#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <new>
#include <set>

#include "clock/child.hpp"
#include "clock/host.hpp"
#include "clock/lockstep_clock.hpp"
#include "clock/participant.hpp"
#include "clock/toy_network.hpp"
#include "mrroc/fnv.hpp"

namespace mrroc::clock::determinism_test {
namespace {

constexpr Tick kLastTick = 20;
constexpr std::uint32_t kOthers = ToyNetwork::kNodes - 1;

/// The clock without the delta rule: messages are visible as soon as they are stored.
class ImmediateClock final : public LockstepClock {
 public:
  using LockstepClock::LockstepClock;
  bool visible(std::uint64_t) const noexcept override { return true; }
};

struct Result {
  std::atomic<std::uint64_t> hash{0};
  std::atomic<std::uint64_t> received{0};
};

/// One process: its messages depend on its name, the tick, and everything that it has received, in order.
void live(Clock& clock, const ToyNetwork& network, std::uint32_t node, Result& result) {
  ToyNode toy(network, node, clock);
  if (!clock.start()) return;
  Fnv1a log;
  log.add(std::uint64_t{node});
  for (Wake wake = Wake::tick; wake != Wake::interrupted;) {
    stray(20);
    log.add(clock.tick());
    log.add(clock.delta());
    const auto draw = [&log](std::uint64_t choices) {
      log.add(choices);
      return static_cast<std::uint32_t>((log.value() >> 17) % choices);
    };
    const auto other = [&] { return (node + 1 + draw(kOthers)) % (kOthers + 1); };
    for (const ToyNetwork::Message& message : toy.receive()) {
      log.add(std::uint64_t{message.from});
      log.add(message.sequence);
      result.received.fetch_add(1);
      if (message.hops > 0) toy.send(other(), message.hops - 1);
    }
    if (clock.tick() >= kLastTick) return result.hash.store(log.value());
    for (std::uint32_t count = wake == Wake::tick ? draw(4) : 0; count > 0; --count) toy.send(other(), draw(4));
    wake = clock.wait(std::min(clock.tick() + 1 + draw(3), kLastTick));
  }
}

using Results = std::array<Result, ToyNetwork::kNodes>;

class Determinism : public ::testing::Test {
 protected:
  Determinism()
      : shared_(::mmap(nullptr, sizeof(Results), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
        busy_{Child(spin), Child(spin)} {}
  ~Determinism() override { ::munmap(shared_, sizeof(Results)); }

  static void spin() {
    for (std::atomic<unsigned> turns{0};;) turns.fetch_add(1, std::memory_order_relaxed);
  }

  /// Runs eight processes to the last tick; returns one hash over all their logs.
  std::uint64_t run(bool delta_rule) {
    Results& results = *new (shared_) Results;
    HostOptions options;
    for (std::size_t node = 0; node < ToyNetwork::kNodes; ++node)
      options.participants.push_back(ToyNetwork::name(node));
    ClockHost host(options);
    const ToyNetwork network;
    std::vector<Child> children;
    for (std::uint32_t node = 0; node < ToyNetwork::kNodes; ++node)
      children.emplace_back([&, node] {
        stray(200);
        if (delta_rule)
          live(*attach_clock(host.fd(), ToyNetwork::name(node), node == 0 ? Part::world : Part::task), network, node,
               results[node]);
        else {
          ImmediateClock clock(MappedClock::attach(host.fd()), node);
          live(clock, network, node, results[node]);
        }
      });
    EXPECT_TRUE(host.wait_ready(60).empty());
    host.start();
    for (Child& child : children) EXPECT_TRUE(child.join()) << host.describe();
    EXPECT_EQ(host.state(), State::running) << host.error();
    Fnv1a hash;
    received_ = 0;
    for (const Result& result : results) {
      EXPECT_NE(result.hash.load(), 0U);
      hash.add(result.hash.load());
      received_ += result.received.load();
    }
    return hash.value();
  }

  void* shared_;
  std::uint64_t received_ = 0;
  std::array<Child, 2> busy_;
};

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr int kRuns = 20;
#else
constexpr int kRuns = 200;
#endif

TEST_F(Determinism, EightProcessesReceiveTheSameInEveryRunUnderLoad) {
  const std::uint64_t first = run(true);
  EXPECT_GT(received_, 100U);
  for (int i = 1; i < kRuns; ++i) {
    ASSERT_EQ(run(true), first) << "run " << i;
    ASSERT_FALSE(HasFailure());
  }
}

TEST_F(Determinism, WithoutTheDeltaRuleRunsDiffer) {
  std::set<std::uint64_t> hashes;
  for (int i = 0; i < kRuns && hashes.size() < 2; ++i) hashes.insert(run(false));
  EXPECT_GE(hashes.size(), 2U);
}

}  // namespace
}  // namespace mrroc::clock::determinism_test
