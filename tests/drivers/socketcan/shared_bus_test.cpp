// Two robots on one bus: each has its own master, SYNC and nodes.
#include <gtest/gtest.h>

#include "can_rig.hpp"

namespace mrroc::edp {
namespace {

/// Number `robot` on a bus, 0 or 1.
config::DriveTable table_of(int robot) {
  config::DriveTable table = table_for(Gantry{}.parameters(), canopen::DriveMode::cyclic_position);
  table.missed_max = 0;
  if (robot == 0) return table;
  table.master = 126;
  table.sync = canopen::kSync + table.master;
  for (config::DriveEntry& drive : table.drives) drive.node = static_cast<canopen::NodeId>(drive.node + 10);
  return table;
}

/// One robot of the bus, without a servo, in lockstep.
struct OneRobot {
  OneRobot(int number, const TestBus& bus) : table(table_of(number)), rack(table, model, bus, true) { connect(bus); }
  void connect(const TestBus& bus) {
    hardware.reset();
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kCanPeriod, bus.opener(),
                                             CanHardware::Timing{10, false, true}, true);
    hardware->open();
  }
  void run() {
    hardware->read(tick, input);
    hardware->set_points(input.motors, JointVector::Zero(4));
    hardware->write(tick++, JointVector::Zero(4));
  }

  Gantry model;
  config::DriveTable table;
  Rack rack;
  std::unique_ptr<CanHardware> hardware;
  HardwareInput input;
  Tick tick = 1;
};

struct SharedBus : testing::Test {
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      first.run();
      second.run();
    }
  }
  std::string problem_of(const OneRobot& robot) {
    return std::string(describe(robot.input.fault)).append(": ").append(describe(robot.input.fault_detail).view());
  }
  TestBus bus;
  OneRobot first{0, bus}, second{1, bus};
};

TEST_F(SharedBus, EachRobotHasItsOwnCycles) {
  const std::uint64_t begins[] = {first.rack.cycles(), second.rack.cycles()};
  run(30);
  for (int i = 0; i < 10; ++i) first.run();
  EXPECT_EQ(first.input.fault, ErrorCode::none) << problem_of(first);
  EXPECT_EQ(second.input.fault, ErrorCode::none) << problem_of(second);
  EXPECT_EQ(first.rack.cycles(), begins[0] + 40);
  EXPECT_EQ(second.rack.cycles(), begins[1] + 30);
}

TEST_F(SharedBus, RobotThatStartsAgainLeavesTheOtherAlone) {
  first.hardware->enable(true);
  for (int i = 0; i < 500 && first.hardware->busy(); ++i) run(1);
  ASSERT_FALSE(first.hardware->busy());
  second.connect(bus);  // its end and its start: NMT commands, resets, SYNCs
  run(20);
  EXPECT_EQ(first.input.fault, ErrorCode::none) << problem_of(first);
  EXPECT_EQ(second.input.fault, ErrorCode::none) << problem_of(second);
  first.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_TRUE(node.powered()) << int{node.node()};
  });
}

TEST_F(SharedBus, SilentDriveIsAFaultOfItsRobotAlone) {
  run(5);
  second.rack.with([](auto& nodes) { nodes[1].cut(true); });
  run(5);
  EXPECT_EQ(first.input.fault, ErrorCode::none) << problem_of(first);
  EXPECT_EQ(second.input.fault, ErrorCode::hardware_silent);
  EXPECT_EQ(second.input.fault_axis, 1);
}

TEST_F(SharedBus, BroadcastOfTheOtherMasterIsAFault) {
  run(5);
  bus.open()->send(canopen::nmt_frame(canopen::NmtCommand::start, 0));
  for (int i = 0; i < 1000 && first.input.fault == ErrorCode::none; ++i) first.run();
  EXPECT_EQ(first.input.fault, ErrorCode::bus_error);
}

TEST_F(SharedBus, CommandToANodeOfTheOtherRobotIsAFaultOfThatRobot) {
  run(5);
  bus.open()->send(canopen::nmt_frame(canopen::NmtCommand::start, second.table.drives[0].node));
  for (int i = 0; i < 1000 && second.input.fault == ErrorCode::none; ++i) run(1);
  EXPECT_EQ(second.input.fault, ErrorCode::bus_error);
  EXPECT_EQ(first.input.fault, ErrorCode::none) << problem_of(first);
}

}  // namespace
}  // namespace mrroc::edp
