#include "cli/run/shutdown.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "clock/participant.hpp"

namespace mrroc::cli::shutdown_test {
namespace {

/// A process group of one EDP that takes part in its clock, which runs, until a test makes it leave.
class OrderlyEnd : public testing::Test {
 protected:
  void SetUp() override {
    std::thread edp([this] {
      edp_ = clock::attach_clock(clock_.fd(), "arm_edp", clock::Part::drives);
      edp_->start();
    });
    ASSERT_TRUE(clock_.wait_ready(60).empty());
    clock_.start();
    edp.join();
    PlannedProcess process;
    process.name = "arm_edp";
    process.program = "/bin/sh";
    process.part = clock::Part::drives;
    group_.start(process, {"-c", "trap '" + at_end() + "' TERM; sleep 10 & echo ready; while :; do wait; done"});
    while (!ready_) group_.wait(20, -1);
  }

  static clock::HostOptions options() {
    clock::HostOptions options;
    options.mode = clock::Mode::real;
    options.participants = {"arm_edp"};
    return options;
  }

  /// The reaction of the process to the request to end.
  virtual std::string at_end() const { return "kill $!; exit 0"; }

  clock::ClockHost clock_{options()};
  std::unique_ptr<clock::Clock> edp_;
  bool ready_ = false;
  ProcessGroup group_{[this](const std::string&, const std::string& line) { ready_ = ready_ || line == "ready"; }};
};

TEST_F(OrderlyEnd, ReportsAClockThatFailsMeanwhile) {
  std::vector<std::string> reported;
  shut_down(group_, clock_, true,
            {.turn =
                 [this] {
                   clock_.fail("the pendulum is stuck");
                   group_.wait(20, -1);
                 },
             .message = [](const std::string&) {},
             .failed = [&reported](const std::string& reason) { reported.push_back(reason); }});
  EXPECT_EQ(reported, (std::vector<std::string>{"clock lost: the pendulum is stuck"}));
  EXPECT_TRUE(group_.all_ended());
}

/// Ends the processes; the EDP leaves the clock at the first pass. Returns the failures that are reported.
std::vector<std::string> failures_after_leaving(ProcessGroup& group, clock::ClockHost& clock,
                                                std::unique_ptr<clock::Clock>& edp) {
  std::vector<std::string> failures;
  shut_down(group, clock, true,
            {.turn =
                 [&group, &edp] {
                   edp.reset();
                   group.wait(20, -1);
                 },
             .message = [](const std::string&) {},
             .failed = [&failures](const std::string& reason) { failures.push_back(reason); },
             .end_timeout = 1});
  EXPECT_TRUE(group.all_ended());
  return failures;
}

TEST_F(OrderlyEnd, RobotHasStoppedWhenItsProcessHasLeftTheClock) {
  EXPECT_EQ(failures_after_leaving(group_, clock_, edp_), std::vector<std::string>{});
}

class SlowEnd : public OrderlyEnd {
  std::string at_end() const override { return "sleep 0.3; kill $!; exit 0"; }
};

TEST_F(SlowEnd, AfterLeavingTheClockIsNoFailure) {
  EXPECT_EQ(failures_after_leaving(group_, clock_, edp_), std::vector<std::string>{});
}

class FailingEnd : public OrderlyEnd {
  std::string at_end() const override { return "kill $!; echo the disk is full; exit 3"; }
};

TEST_F(FailingEnd, AfterLeavingTheClockIsReported) {
  EXPECT_EQ(failures_after_leaving(group_, clock_, edp_),
            (std::vector<std::string>{"process arm_edp failed at the end: exit code 3: the disk is full"}));
}

class CrashAtTheEnd : public OrderlyEnd {
  std::string at_end() const override { return "kill $!; kill -SEGV $$"; }
};

TEST_F(CrashAtTheEnd, AfterLeavingTheClockIsReported) {
  EXPECT_EQ(failures_after_leaving(group_, clock_, edp_),
            (std::vector<std::string>{"process arm_edp failed at the end: signal 11 (Segmentation fault)"}));
}

class NoEnd : public OrderlyEnd {
  std::string at_end() const override { return ":"; }
};

TEST_F(NoEnd, AfterLeavingTheClockIsReportedOnKill) {
  EXPECT_EQ(failures_after_leaving(group_, clock_, edp_),
            (std::vector<std::string>{"process arm_edp failed at the end: signal 9 (Killed)"}));
}

/// In lockstep, with a tick that takes `pause` of wall time; the process leaves after `ticks` of them. Returns the
/// failures.
std::vector<std::string> failures_in_lockstep(Tick ticks, std::chrono::milliseconds pause, double stop_timeout,
                                              clock::Part part = clock::Part::drives) {
  clock::HostOptions options;
  options.participants = {"moving"};
  clock::ClockHost host(options);
  std::thread moving([&host, ticks, pause, part] {
    const auto clock = clock::attach_clock(host.fd(), "moving", part);
    clock->start();
    while (host.stop_tick() == kNever || clock->tick() < host.stop_tick() + ticks) {
      if (clock->wait(clock->tick() + 1) == clock::Wake::interrupted) break;
      std::this_thread::sleep_for(pause);
    }
  });
  EXPECT_TRUE(host.wait_ready(60).empty());
  host.start();
  std::vector<std::string> failures;
  ProcessGroup group([](const std::string&, const std::string&) {});
  PlannedProcess process;
  process.name = "moving";
  process.program = "/bin/sh";
  process.part = part;
  group.start(process, {"-c", "trap 'kill $!; exit 0' TERM; sleep 60 & while :; do wait; done"});
  shut_down(group, host, true,
            {.turn = [&group] { group.wait(20, -1); },
             .message = [](const std::string&) {},
             .failed = [&failures](const std::string& reason) { failures.push_back(reason); },
             .stop_timeout = stop_timeout,
             .end_timeout = 1});
  host.end();
  moving.join();
  return failures;
}

TEST(SlowSimulation, HasTheSimulatedTimeToStop) {
  EXPECT_EQ(failures_in_lockstep(100, std::chrono::milliseconds(10), 0.25), std::vector<std::string>{})
      << "0.2 s of simulated time, at least 1 s of wall time";
}

TEST(SlowSimulation, RobotThatDoesNotStopIsReported) {
  const auto failures = failures_in_lockstep(100'000, std::chrono::milliseconds(1), 0.25);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].find("not every robot has stopped within 0.25 s; clock "), 0U) << failures[0];
}

TEST(SlowSimulation, TimeThatStandsStillIsReported) {
  const auto failures = failures_in_lockstep(100, std::chrono::milliseconds(3000), 0.25);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].find("not every robot has stopped within 0.25 s; clock "), 0U) << failures[0];
}

TEST(SlowSimulation, WorldWithoutDrivenRobotsMayLeaveLate) {
  EXPECT_EQ(failures_in_lockstep(100, std::chrono::milliseconds(1500), 0.25, clock::Part::world),
            std::vector<std::string>{});
}

}  // namespace
}  // namespace mrroc::cli::shutdown_test
