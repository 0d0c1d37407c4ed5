#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "clock/thread_deployment.hpp"
#include "clock/toy_network.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::clock::lockstep_test {
namespace {

TEST(Lockstep, WaitEndsAtExactlyItsTick) {
  ThreadDeployment deployment({"a", "b"});
  std::vector<Tick> a;
  std::vector<Tick> b;
  deployment.add("a", [&a](Clock& clock) {
    for (const Tick tick : {1, 2, 7, 1000}) {
      EXPECT_EQ(clock.wait(tick), Wake::tick);
      a.push_back(clock.tick());
    }
  });
  deployment.add("b", [&b](Clock& clock) {
    EXPECT_EQ(clock.tick(), 0U);
    while (clock.tick() < 2000) {
      EXPECT_EQ(clock.wait(clock.tick() + 250), Wake::tick);
      b.push_back(clock.tick());
    }
  });
  deployment.start();
  deployment.join();
  EXPECT_EQ(a, (std::vector<Tick>{1, 2, 7, 1000}));
  EXPECT_EQ(b, (std::vector<Tick>{250, 500, 750, 1000, 1250, 1500, 1750, 2000}));
  EXPECT_EQ(deployment.host.tick(), 2000U);
}

TEST(Lockstep, WorldStepsBeforeParticipantsReachTheTick) {
  ThreadDeployment deployment({"arm", "world", "belt"});
  std::atomic<Tick> world{kNever};
  const auto check = [&world](Clock& clock) {
    do {
      stray(20);
      EXPECT_EQ(world.load(), clock.tick());
    } while (clock.wait(clock.tick() + 1) == Wake::tick && clock.tick() < 50);
  };
  deployment.add("arm", check);
  deployment.add(
      "world",
      [&world](Clock& clock) {
        do {
          stray(20);
          world.store(clock.tick());
        } while (clock.wait(clock.tick() + 1) == Wake::tick && clock.tick() < 50);
      },
      Part::world);
  deployment.add("belt", check);
  deployment.start();
  deployment.join();
}

TEST(Lockstep, MessageIsVisibleInTheNextDeltaOfTheSameTick) {
  ThreadDeployment deployment({"a", "b"});
  Clock& a = deployment.attach("a");
  const int sender = a.register_sender("a/b");
  std::atomic<std::uint64_t> stamp{0};
  std::atomic<bool> looked{false};
  int receiver = -1;
  Clock* b = nullptr;
  deployment.body([&](Clock& clock) {
    stamp.store(clock.delta());
    clock.sent(sender);
    b->arrived(receiver);
    while (!looked.load()) std::this_thread::yield();  // both run in this delta
  });
  b = &deployment.add("b", [&](Clock& clock) {
    while (stamp.load() == 0) std::this_thread::yield();
    EXPECT_FALSE(clock.visible(stamp.load()));
    looked.store(true);
    EXPECT_EQ(clock.wait(5), Wake::mail);
    EXPECT_EQ(clock.tick(), 0U);
    EXPECT_TRUE(clock.visible(stamp.load()));
    EXPECT_EQ(clock.wait(5), Wake::tick);
    EXPECT_EQ(clock.tick(), 5U);
  });
  receiver = b->register_receiver("a/b");
  deployment.start();
  deployment.join();
}

TEST(Lockstep, MessageInFlightHoldsTheTime) {
  ThreadDeployment deployment({"a", "b"});
  Clock& a = deployment.attach("a");
  const int sender = a.register_sender("a/b");
  deployment.body([sender](Clock& clock) { clock.sent(sender); });
  Clock& b = deployment.add("b", [](Clock& clock) {
    EXPECT_EQ(clock.wait(100), Wake::mail);
    EXPECT_EQ(clock.tick(), 0U);
  });
  const int receiver = b.register_receiver("a/b");
  deployment.start();
  const std::string held = "running at tick 0, delta 1; in flight on a/b to b: 1";
  while (deployment.host.describe() != held) std::this_thread::yield();
  stray(2000);
  EXPECT_EQ(deployment.host.describe(), held);
  b.arrived(receiver);
  deployment.join();
}

TEST(Lockstep, EventsRunBeforeTheirTickAndTheirMessagesAreVisibleAtIt) {
  ThreadDeployment deployment({"a"});
  const std::unique_ptr<Clock> panel = deployment.host.operator_clock();
  const int sender = panel->register_sender("panel/a");
  int receiver = -1;
  std::vector<std::pair<Tick, Tick>> events;  // scheduled, newest visible
  std::vector<std::pair<Tick, Wake>> wakes;
  std::atomic<std::uint64_t> stamp{0};
  Clock& a = deployment.add("a", [&](Clock& clock) {
    Wake wake = Wake::tick;
    while (clock.tick() < 10) {
      wake = clock.wait(10);
      wakes.emplace_back(clock.tick(), wake);
      EXPECT_TRUE(clock.visible(stamp.load()));
    }
  });
  receiver = a.register_receiver("panel/a");
  for (const Tick event_tick : {4, 0, 7})
    deployment.host.at_tick(event_tick, [&](Tick tick) {
      events.emplace_back(tick, deployment.host.tick());
      stamp.store(panel->delta());
      if (tick == 0) return;
      panel->sent(sender);
      a.arrived(receiver);
    });
  deployment.start();
  deployment.join();
  EXPECT_EQ(events, (std::vector<std::pair<Tick, Tick>>{{0, 0}, {4, 3}, {7, 6}}));
  EXPECT_EQ(wakes, (std::vector<std::pair<Tick, Wake>>{{4, Wake::mail}, {7, Wake::mail}, {10, Wake::tick}}));
}

TEST(Lockstep, PassedWakeTickEndsTheWaitInTheNextDelta) {
  ThreadDeployment deployment({"a"});
  deployment.add("a", [](Clock& clock) {
    const std::uint64_t delta = clock.delta();
    EXPECT_EQ(clock.wait(0), Wake::tick);
    EXPECT_EQ(clock.tick(), 0U);
    EXPECT_EQ(clock.delta(), delta + 1);
  });
  deployment.start();
  deployment.join();
}

TEST(Lockstep, StartOrderDoesNotMatter) {
  std::minstd_rand random(7);
  for (int run = 0; run < 20; ++run) {
    std::vector<std::string> names{"a", "b", "c", "d", "e"};
    ThreadDeployment deployment(names);
    std::shuffle(names.begin(), names.end(), random);
    for (const std::string& name : names)
      deployment.add(name, [](Clock& clock) {
        EXPECT_EQ(clock.tick(), 0U);
        EXPECT_EQ(clock.delta(), 1U);
      });
    deployment.start();
    deployment.join();
  }
}

TEST(Lockstep, TimeDoesNotWaitForAParticipantThatHasLeft) {
  ThreadDeployment deployment({"a", "b"});
  Clock& a = deployment.attach("a");
  const int sender = a.register_sender("a/b");
  deployment.body([sender](Clock& clock) {
    EXPECT_EQ(clock.wait(3), Wake::tick);
    clock.sent(sender);  // it will never be received
    EXPECT_EQ(clock.wait(6), Wake::tick);
  });
  Clock& b = deployment.add("b", [](Clock& clock) { EXPECT_EQ(clock.wait(2), Wake::tick); });
  b.register_receiver("a/b");
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.tick(), 6U);
}

TEST(Lockstep, InterruptIsStickyAndTheOthersContinue) {
  ThreadDeployment deployment({"a", "b"});
  std::atomic<bool> interrupted{false};
  Clock& a = deployment.add("a", [&interrupted](Clock& clock) {
    EXPECT_EQ(clock.wait(kNever), Wake::interrupted);
    EXPECT_EQ(clock.wait(0), Wake::interrupted);
    interrupted.store(true);
  });
  deployment.add("b", [&](Clock& clock) {
    EXPECT_EQ(clock.wait(3), Wake::tick);
    a.interrupt();
    while (!interrupted.load()) std::this_thread::yield();
    EXPECT_EQ(clock.wait(9), Wake::tick);
  });
  deployment.start();
  deployment.join();
}

TEST(Lockstep, MailFromALiveOperatorWakesADeploymentThatWaits) {
  HostOptions options;
  options.live_operator = true;
  ThreadDeployment deployment({"a"}, options);
  const std::unique_ptr<Clock> panel = deployment.host.operator_clock();
  const int sender = panel->register_sender("panel/a");
  Clock& a = deployment.add("a", [](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::mail); });
  const int receiver = a.register_receiver("panel/a");
  deployment.start();
  EXPECT_TRUE(panel->start());
  while (deployment.host.delta() == 0) std::this_thread::yield();  // earlier mail is visible from the start
  stray(2000);
  panel->sent(sender);
  a.arrived(receiver);
  deployment.join();
  EXPECT_EQ(deployment.host.error(), "");
}

TEST(Lockstep, TheOperatorWaitsForMailTicksAndTheEnd) {
  ThreadDeployment deployment({"a"});
  const std::unique_ptr<Clock> panel = deployment.host.operator_clock();
  const int receiver = panel->register_receiver("a/panel");
  std::atomic<bool> go_on{false};
  deployment.add("a", [&](Clock& clock) {
    clock.wait(5);
    while (!go_on.load()) std::this_thread::yield();
  });
  deployment.start();
  EXPECT_TRUE(panel->start());
  while (panel->wait(5) != Wake::tick) {
  }
  EXPECT_EQ(panel->tick(), 5U);
  panel->arrived(receiver);
  EXPECT_EQ(panel->wait(kNever), Wake::mail);
  go_on.store(true);
  deployment.join();
  EXPECT_EQ(panel->wait(kNever), Wake::interrupted);
}

}  // namespace
}  // namespace mrroc::clock::lockstep_test
