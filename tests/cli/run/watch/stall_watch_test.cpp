#include "cli/run/watch/stall_watch.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "clock/thread_deployment.hpp"

namespace mrroc::cli::stall_watch_test {
namespace {

using clock::Clock;
using clock::HostOptions;
using clock::Mode;
using clock::ThreadDeployment;

HostOptions with(Mode mode) {
  HostOptions options;
  options.mode = mode;
  return options;
}

/// One process that computes without waiting until it is instructed to end, and one that waits.
class Stalled {
 public:
  explicit Stalled(Mode mode) : deployment_({"busy", "idle"}, with(mode)) {
    deployment_.add("busy", [this](Clock& clock) {
      clock.wait(1);
      computes_ = true;
      while (!done_) {
      }
      clock.wait(kNever);
    });
    deployment_.add("idle", [](Clock& clock) { clock.wait(kNever); });
    deployment_.start();
    while (!computes_) {
    }
  }
  ~Stalled() {
    done_ = true;
    deployment_.host.end();
    deployment_.join();
  }
  Stalled(const Stalled&) = delete;
  Stalled& operator=(const Stalled&) = delete;

  const clock::ClockHost& clock() const { return deployment_.host; }
  /// Waits until every process waits.
  void calm_down() {
    done_ = true;
    while (!deployment_.host.at_work().empty() || deployment_.host.waits_for_somebody()) {
    }
  }

 private:
  std::atomic<bool> computes_ = false, done_ = false;
  ThreadDeployment deployment_;
};

TEST(StallWatch, RealClockNamesAComputingProcessEverLessOften) {
  Stalled stalled(Mode::real);
  StallWatch watch(stalled.clock());
  EXPECT_EQ(watch.check(10), "");
  EXPECT_EQ(watch.check(11.9), "");
  EXPECT_EQ(watch.check(12), "busy has waited for nothing for 2 s: it computes, or is blocked outside of MRROC++");
  EXPECT_EQ(watch.check(12.1), "");
  EXPECT_EQ(watch.check(13.9), "");
  EXPECT_EQ(watch.check(14), "busy has waited for nothing for 4 s: it computes, or is blocked outside of MRROC++");
  EXPECT_EQ(watch.check(17.9), "");
  stalled.calm_down();
  EXPECT_EQ(watch.check(100), "") << "a long wait for a message is not a stall";
}

TEST(StallWatch, NamesTheRunningProcessWhileSimulatedTimeStandsStill) {
  Stalled stalled(Mode::lockstep);
  StallWatch watch(stalled.clock());
  EXPECT_EQ(watch.check(10), "");
  const std::string line = watch.check(12);
  EXPECT_EQ(line.find("nothing has happened for 2 s; clock running at tick 1"), 0U) << line;
  EXPECT_NE(line.find("at work: busy"), std::string::npos) << line;
  EXPECT_EQ(watch.check(13), "");
  stalled.calm_down();
  EXPECT_EQ(watch.check(100), "");
}

}  // namespace
}  // namespace mrroc::cli::stall_watch_test
