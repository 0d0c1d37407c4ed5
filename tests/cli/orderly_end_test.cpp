#include "cli/orderly_end.hpp"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "clock/participant.hpp"

namespace mrroc::cli {
namespace {

/// A crew of one EDP that does not stop by itself, and its clock, which runs.
class OrderlyEnd : public testing::Test {
 protected:
  void SetUp() override {
    edp_ = std::thread([this] { clock::attach_clock(clock_.fd(), "arm_edp", clock::Part::drives)->start(); });
    ASSERT_TRUE(clock_.wait_ready(60).empty());
    clock_.start();
    edp_.join();
    PlannedProcess process;
    process.name = "arm_edp";
    process.program = "/bin/sleep";
    process.part = clock::Part::drives;
    crew_.start(process, {"60"});
  }

  static clock::HostOptions options() {
    clock::HostOptions options;
    options.mode = clock::Mode::real;
    options.participants = {"arm_edp"};
    return options;
  }

  clock::ClockHost clock_{options()};
  std::thread edp_;
  Crew crew_{[](const std::string&, const std::string&) {}};
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

}  // namespace
}  // namespace mrroc::cli
