#include <gtest/gtest.h>

#include "clock/thread_deployment.hpp"
#include "clock/toy_network.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::clock::wall_time_test {
namespace {

HostOptions with(Mode mode, double period) {
  HostOptions options;
  options.mode = mode;
  options.period = period;
  return options;
}

TEST(Paced, NoTickBeginsBeforeItsTime) {
  ThreadDeployment deployment({"a"}, with(Mode::paced, 0.001));
  std::vector<std::int64_t> begun;
  std::int64_t epoch = 0;
  deployment.add("a", [&](Clock& clock) {
    EXPECT_TRUE(clock.simulated());
    epoch = clock.epoch_ns();
    while (clock.wait(clock.tick() + 1) == Wake::tick && clock.tick() < 40) {
    }
  });
  for (Tick tick = 0; tick < 40; ++tick)
    deployment.host.at_tick(tick, [&begun](Tick) { begun.push_back(monotonic_ns()); });
  deployment.start();
  deployment.join();
  ASSERT_EQ(begun.size(), 40U);
  for (std::size_t k = 0; k < begun.size(); ++k)
    EXPECT_GE(begun[k], epoch + static_cast<std::int64_t>(k) * 1'000'000) << "tick " << k;
}

TEST(Paced, CountsAnOverrunAndLosesNoTick) {
  ThreadDeployment deployment({"a"}, with(Mode::paced, 0.001));
  std::vector<Tick> ticks;
  deployment.add("a", [&ticks](Clock& clock) {
    while (clock.wait(clock.tick() + 1) == Wake::tick && clock.tick() < 10) {
      ticks.push_back(clock.tick());
      const std::int64_t end = clock.epoch_ns() + 8'500'000;
      while (clock.tick() == 5 && monotonic_ns() < end) {
      }
    }
  });
  deployment.start();
  deployment.join();
  EXPECT_EQ(ticks, (std::vector<Tick>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_GE(deployment.host.late_ticks(), 1U);
}

TEST(Paced, OperatorMailIsDeliveredBetweenTicks) {
  ThreadDeployment deployment({"a"}, with(Mode::paced, 10));
  const std::unique_ptr<Clock> panel = deployment.host.operator_clock();
  const int sender = panel->register_sender("panel/a");
  Clock& a = deployment.add("a", [](Clock& clock) {
    EXPECT_EQ(clock.wait(1'000'000), Wake::mail);
    EXPECT_EQ(clock.tick(), 0U);
  });
  const int receiver = a.register_receiver("panel/a");
  deployment.start();
  while (deployment.host.describe() != "running at tick 0, delta 1") std::this_thread::yield();
  panel->sent(sender);
  a.arrived(receiver);
  deployment.join();
}

TEST(Real, TicksFollowTheMonotonicClock) {
  ThreadDeployment deployment({"a", "b"}, with(Mode::real, 0.001));
  const auto body = [](Clock& clock) {
    EXPECT_FALSE(clock.simulated());
    Tick last = 0;
    for (int i = 0; i < 20; ++i) {
      const Tick wanted = last + 2;
      ASSERT_EQ(clock.wait(wanted), Wake::tick);
      const std::int64_t before = monotonic_ns();
      const Tick tick = clock.tick();
      const std::int64_t after = monotonic_ns();
      EXPECT_GE(tick, wanted);
      EXPECT_GE(tick, static_cast<Tick>((before - clock.epoch_ns()) / 1'000'000));
      EXPECT_LE(tick, static_cast<Tick>((after - clock.epoch_ns()) / 1'000'000));
      last = tick;
    }
  };
  Clock& a = deployment.add("a", body);
  Clock& b = deployment.add("b", body);
  EXPECT_EQ(a.tick(), 0U);
  deployment.start();
  EXPECT_EQ(a.epoch_ns(), b.epoch_ns());
  deployment.join();
}

TEST(Real, MailNotificationAndInterruptEndAWait) {
  ThreadDeployment deployment({"a"}, with(Mode::real, 0.001));
  std::atomic<int> waits{0};
  Clock& a = deployment.add("a", [&waits](Clock& clock) {
    EXPECT_TRUE(clock.visible(12345));
    for (const Wake expected : {Wake::mail, Wake::mail, Wake::interrupted, Wake::interrupted}) {
      EXPECT_EQ(clock.wait(kNever), expected);
      waits.fetch_add(1);
    }
  });
  const int receiver = a.register_receiver("t");
  deployment.start();
  a.arrived(receiver);
  while (waits.load() < 1) std::this_thread::yield();
  stray(2000);
  a.notify();
  while (waits.load() < 2) std::this_thread::yield();
  a.interrupt();
  deployment.join();
}

TEST(Real, EarlyMailOpensNoBarrierAndIsFoundByTheFirstWait) {
  ThreadDeployment deployment({"a"}, with(Mode::real, 0.001));
  Clock& a = deployment.add("a", [](Clock& clock) {
    EXPECT_NE(clock.epoch_ns(), 0);
    EXPECT_EQ(clock.wait(kNever), Wake::mail);
  });
  a.notify();
  deployment.start();
  deployment.join();
}

TEST(Real, EventsRunInOrderAndNotBeforeTheirTime) {
  ThreadDeployment deployment({"a"}, with(Mode::real, 0.001));
  std::vector<Tick> scheduled;
  deployment.add("a", [](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::interrupted); });
  for (const Tick tick : {9, 3, 6})
    deployment.host.at_tick(tick, [&, tick](Tick) {
      EXPECT_GE(deployment.host.tick(), tick);
      scheduled.push_back(tick);
      if (tick == 9) deployment.host.fail("enough");
    });
  deployment.start();
  deployment.join();
  EXPECT_EQ(scheduled, (std::vector<Tick>{3, 6, 9}));
}

}  // namespace
}  // namespace mrroc::clock::wall_time_test
