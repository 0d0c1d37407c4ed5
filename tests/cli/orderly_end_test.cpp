#include "cli/orderly_end.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "clock/participant.hpp"

namespace mrroc::cli {
namespace {

/// A crew of one EDP that takes part in its clock, which runs, until a test has it leave.
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
    crew_.start(process, {"-c", script()});
    while (!ready_) crew_.wait(20, -1);
  }

  static clock::HostOptions options() {
    clock::HostOptions options;
    options.mode = clock::Mode::real;
    options.participants = {"arm_edp"};
    return options;
  }

  /// What its process does: it sleeps.
  virtual std::string script() const { return "echo ready; exec sleep 60"; }

  clock::ClockHost clock_{options()};
  std::unique_ptr<clock::Clock> edp_;
  bool ready_ = false;
  Crew crew_{[this](const std::string&, const std::string& line) { ready_ = ready_ || line == "ready"; }};
};

TEST_F(OrderlyEnd, TellsOfAClockThatFailsMeanwhile) {
  std::vector<std::string> told;
  end_in_order(crew_, clock_, true,
               {.turn =
                    [this] {
                      clock_.fail("the pendulum is stuck");
                      crew_.wait(20, -1);
                    },
                .message = [](const std::string&) {},
                .failed = [&told](const std::string& reason) { told.push_back(reason); }});
  EXPECT_EQ(told, (std::vector<std::string>{"clock lost: the pendulum is stuck"}));
  EXPECT_TRUE(crew_.all_ended());
}

TEST_F(OrderlyEnd, ARobotHasStoppedWhenItsProcessHasLeftTheClockHoweverLongTheProcessTakesToEnd) {
  std::vector<std::string> failures;
  bool ended_before_clock = false;
  end_in_order(crew_, clock_, true,
               {.turn =
                    [this, &ended_before_clock] {
                      if (clock_.state() == clock::State::running) {
                        ended_before_clock = crew_.all_ended();
                        edp_.reset();
                      }
                      crew_.wait(20, -1);
                    },
                .message = [](const std::string&) {},
                .failed = [&failures](const std::string& reason) { failures.push_back(reason); }});
  EXPECT_FALSE(ended_before_clock);
  EXPECT_EQ(failures, std::vector<std::string>{});
  EXPECT_TRUE(crew_.all_ended());
}

/// Its process is asked to end and cannot write what it has recorded.
class FailingEnd : public OrderlyEnd {
  std::string script() const override {
    return "trap 'echo the disk is full; exit 3' TERM; echo ready; sleep 60 & wait";
  }
};

TEST_F(FailingEnd, OfAProcessThatHasLeftTheClockIsReported) {
  std::vector<std::string> failures;
  end_in_order(crew_, clock_, true,
               {.turn =
                    [this] {
                      crew_.wait(20, -1);
                      edp_.reset();
                    },
                .message = [](const std::string&) {},
                .failed = [&failures](const std::string& reason) { failures.push_back(reason); }});
  EXPECT_EQ(failures, (std::vector<std::string>{"process arm_edp failed at the end: exit code 3: the disk is full"}));
}

}  // namespace
}  // namespace mrroc::cli
