#include <atomic>

#include "clock/leave.hpp"
#include "clock/thread_deployment.hpp"

namespace mrroc::clock::stop_test {
namespace {

TEST(ClockStop, TasksAreInterruptedAndTimeGoesOnForDrivesAndWorld) {
  ThreadDeployment deployment({"task", "drives", "world"});
  std::atomic<Tick> task_ended{0};
  Tick seen = 0, standing = 0, world_ended = 0;
  std::atomic<bool> robot_stands{false};
  deployment.add("task", [&task_ended](Clock& clock) {
    while (clock.wait(clock.tick() + 1) == Wake::tick) {
    }
    EXPECT_TRUE(clock.stopping());
    task_ended.store(clock.tick());
  });
  deployment.add(
      "drives",
      [&](Clock& clock) {
        while (!clock.stopping()) EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
        seen = clock.tick();
        for (int i = 0; i < 20; ++i) EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
        standing = clock.tick();
        robot_stands.store(true);
      },
      Part::drives);
  deployment.add(
      "world",
      [&](Clock& clock) {
        while (!robot_stands.load()) EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
        world_ended = clock.tick();
      },
      Part::world);
  deployment.host.at_tick(100, [&deployment](Tick) { deployment.host.stop(); });
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.stop_tick(), 99U) << "the tick of the participants when the event of tick 100 ran";
  EXPECT_EQ(task_ended.load(), 99U);
  EXPECT_EQ(deployment.host.task_end(), 99U);
  EXPECT_EQ(seen, 100U);
  EXPECT_EQ(standing, 120U);
  EXPECT_GE(world_ended, 120U);
}

TEST(ClockStop, TaskThatWaitedForMailIsInTheTickOfTheStop) {
  ThreadDeployment deployment({"task", "drives"});
  std::atomic<Tick> task_ended{0};
  deployment.add("task", [&task_ended](Clock& clock) {
    EXPECT_EQ(clock.wait(kNever), Wake::interrupted);
    task_ended.store(clock.tick());
  });
  deployment.add(
      "drives",
      [](Clock& clock) {
        while (!clock.stopping()) EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
        for (int i = 0; i < 20; ++i) EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
      },
      Part::drives);
  deployment.host.at_tick(100, [&deployment](Tick) { deployment.host.stop(); });
  deployment.start();
  deployment.join();
  EXPECT_EQ(task_ended.load(), deployment.host.stop_tick());
}

TEST(ClockStop, TaskEndIsTheFirstThatIsSaid) {
  ThreadDeployment deployment({"task", "other"});
  deployment.add("task", [](Clock& clock) {
    while (clock.tick() < 50) clock.wait(clock.tick() + 1);
    clock.end_task();
    while (clock.wait(clock.tick() + 1) == Wake::tick) {
    }
  });
  deployment.add("other", [](Clock& clock) {
    while (clock.tick() < 60) clock.wait(clock.tick() + 1);
    clock.end_task();
    while (clock.wait(clock.tick() + 1) == Wake::tick) {
    }
  });
  EXPECT_EQ(deployment.host.task_end(), kNever);
  deployment.host.at_tick(70, [&deployment](Tick) { deployment.host.stop(); });
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.task_end(), 50U);
}

TEST(ClockStop, TaskThatNeverWaitsAgainBlocksNoOther) {
  ThreadDeployment deployment({"task", "drives"});
  std::atomic<bool> computes{false}, end{false};
  deployment.add("task", [&](Clock&) {
    computes.store(true);
    while (!end.load()) std::this_thread::yield();
  });
  deployment.add(
      "drives",
      [](Clock& clock) {
        while (!clock.stopping()) clock.wait(clock.tick() + 1);
        for (int i = 0; i < 20; ++i) EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
      },
      Part::drives);
  deployment.start();
  while (!computes.load()) std::this_thread::yield();
  deployment.host.stop();
  while (deployment.host.tick() < 20) std::this_thread::yield();
  end.store(true);
  deployment.join();
}

void expect_that_time_passes_without_drives(Mode mode) {
  HostOptions options;
  options.mode = mode;
  ThreadDeployment deployment({"drives", "world"}, options);
  std::atomic<bool> left{false};
  std::atomic<Tick> now{0};
  deployment.add(
      "drives",
      [&](Clock& clock) {
        while (!clock.stopping()) clock.wait(clock.tick() + 1);
        leave(clock);
        const Tick begin = now.load();
        left.store(true);
        while (now.load() < begin + 20) std::this_thread::yield();  // it ends, which takes as long as it takes
        EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::interrupted);
      },
      Part::drives);
  deployment.add(
      "world",
      [&](Clock& clock) {
        while (!left.load()) clock.wait(clock.tick() + 1);
        EXPECT_TRUE(deployment.host.has_left("drives"));
        for (int i = 0; i < 40; ++i) {
          EXPECT_EQ(clock.wait(clock.tick() + 1), Wake::tick);
          now.store(clock.tick());
        }
      },
      Part::world);
  deployment.start();
  while (deployment.host.tick() < 5) std::this_thread::yield();
  deployment.host.stop();
  deployment.join();
}

TEST(ClockStop, TimeDoesNotWaitForOneThatHasLeft) {
  expect_that_time_passes_without_drives(Mode::lockstep);
  expect_that_time_passes_without_drives(Mode::real);
}

TEST(ClockStop, InRealTimeDrivesAreWokenAndTasksInterrupted) {
  HostOptions options;
  options.mode = Mode::real;
  ThreadDeployment deployment({"task", "drives"}, options);
  deployment.add("task", [](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::interrupted); });
  deployment.add(
      "drives",
      [](Clock& clock) {
        EXPECT_EQ(clock.wait(kNever), Wake::mail);
        EXPECT_TRUE(clock.stopping());
        EXPECT_EQ(clock.wait(clock.tick() + 3), Wake::tick);
      },
      Part::drives);
  deployment.start();
  while (deployment.host.state() != State::running) std::this_thread::yield();
  deployment.host.stop();
  deployment.join();
}

TEST(ClockStop, StopBeforeTheStartIsTheEnd) {
  HostOptions options;
  options.participants = {"drives"};
  ClockHost host(options);
  host.stop();
  EXPECT_EQ(host.state(), State::ended);
  EXPECT_EQ(host.stop_tick(), kNever);
}

}  // namespace
}  // namespace mrroc::clock::stop_test
