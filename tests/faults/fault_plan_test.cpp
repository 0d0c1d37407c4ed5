#include "faults/fault_plan.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "clock/host.hpp"
#include "clock/participant.hpp"

namespace mrroc::faults {
namespace {

TEST(FaultPlan, GivesAProcessItsOwnFaults) {
  clock::HostOptions options;
  options.participants = {"arm_edp"};
  clock::ClockHost host(options);
  const auto clock = clock::attach_clock(host.fd(), "arm_edp");
  const FaultPlan plan({"kill edp:arm at tick 1", "nan vsp:wrist at tick 1", "fault edp:arm at tick 7 for 3 ticks"});
  const auto switches = plan.of("arm_edp", *clock);
  ASSERT_EQ(switches.size(), 1U) << "the runner sends signals";
  EXPECT_EQ(switches[0].fault().kind, Kind::fault);
  EXPECT_FALSE(switches[0].on(7)) << "it has not been triggered";
  host.set_off_fault(2, 7);
  EXPECT_FALSE(switches[0].on(6));
  EXPECT_TRUE(switches[0].on(7));
  EXPECT_TRUE(switches[0].on(9));
  EXPECT_FALSE(switches[0].on(10));
}

TEST(FaultPlan, GivesTheFaultsOfIoNodesToTheProcessOfTheDrives) {
  clock::HostOptions options;
  options.participants = {"arm_drives"};
  clock::ClockHost host(options);
  const auto clock = clock::attach_clock(host.fd(), "arm_drives");
  const FaultPlan plan({"silence io:arm node 40 at tick 1", "silence drives:arm axis 2 at tick 1",
                        "stick io:other input 0 to 1 at tick 1"});
  const auto switches = plan.of("arm_drives", *clock);
  ASSERT_EQ(switches.size(), 2U);
  EXPECT_EQ(switches[0].fault().io, IoPart::node);
  EXPECT_EQ(switches[1].fault().io, IoPart::none);
}

TEST(FaultPlan, StepTriggersAFaultOnceForAllProcesses) {
  clock::HostOptions options;
  options.participants = {"arm"};
  clock::ClockHost host(options);
  const auto clock = clock::attach_clock(host.fd(), "arm");
  const FaultPlan plan({"fault edp:arm at step 3", "fault edp:arm at step 3 of mp"});
  plan.count_step("arm", 2, 100, *clock);
  EXPECT_EQ(host.fault_tick(0), kNever);
  plan.count_step("arm", 3, 110, *clock);
  EXPECT_EQ(host.fault_tick(0), 111U);
  EXPECT_EQ(host.fault_tick(1), kNever);
  plan.count_step("arm", 3, 500, *clock);
  EXPECT_EQ(host.fault_tick(0), 111U) << "the first trigger counts";
}

TEST(FaultPlan, RefusesMoreThanTheClockCanHold) {
  EXPECT_THROW(FaultPlan(std::vector<std::string>(33, "kill mp at tick 1")), std::invalid_argument);
  EXPECT_EQ(FaultPlan(std::vector<std::string>(32, "kill mp at tick 1")).all().size(), 32U);
}

}  // namespace
}  // namespace mrroc::faults
