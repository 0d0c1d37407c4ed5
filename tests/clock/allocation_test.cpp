#include <gtest/gtest.h>

#include "allocations.hpp"
#include "clock/thread_deployment.hpp"
#include "clock/wall/ticker.hpp"

namespace mrroc::clock::allocation_test {
namespace {

std::uint64_t allocations_of(const std::function<void()>& action) {
  const std::uint64_t before = test::thread_allocations();
  action();
  return test::thread_allocations() - before;
}

TEST(Allocation, CounterCounts) {
  EXPECT_EQ(allocations_of([] { ::operator delete(::operator new(8)); }), 1U);
}

TEST(Allocation, NoneInWaitSentAndArrived) {
  for (const Mode mode : {Mode::lockstep, Mode::real}) {
    HostOptions options;
    options.mode = mode;
    options.period = 0.001;
    ThreadDeployment deployment({"a"}, options);
    Clock& a = deployment.attach("a");
    const int sender = a.register_sender("t");
    const int receiver = a.register_receiver("t");
    deployment.body([=](Clock& clock) {
      EXPECT_EQ(allocations_of([&] {
                  for (Tick tick = 1; tick < 20; ++tick) {
                    clock.sent(sender);
                    clock.arrived(receiver);
                    while (clock.wait(tick) == Wake::mail) {
                    }
                  }
                }),
                0U);
    });
    deployment.start();
    deployment.join();
  }
}

TEST(Allocation, NoneInATicker) {
  Ticker ticker(0, 100'000);
  EXPECT_EQ(allocations_of([&] {
              for (int i = 0; i < 20; ++i) ticker.wait_next();
              EXPECT_GT(ticker.statistics().lateness().percentile(0.99) + ticker.statistics().execution().max(), 0U);
            }),
            0U);
}

}  // namespace
}  // namespace mrroc::clock::allocation_test
