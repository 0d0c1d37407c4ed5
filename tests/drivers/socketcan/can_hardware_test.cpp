#include "drivers/socketcan/can_hardware.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "can_rig.hpp"
#include "repetitions.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;
using canopen::DriveState;

constexpr double kIncrement = 2 * std::numbers::pi / 4000;

class EveryMode : public testing::TestWithParam<DriveMode> {};

TEST_P(EveryMode, RobotReachesItsTarget) {
  CanRig<Gantry> rig(GetParam());
  ASSERT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  const JointVector begin = rig.seen().joints;
  const JointVector way = (JointVector(4) << 0.2, -0.1, 0.15, 0.3).finished();
  ASSERT_FALSE(rig.send(relative_joints(way, 500)));
  rig.run(700);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.error_class, ErrorClass::none) << rig.replies[0].state.error.detail.view();
  EXPECT_LT((rig.seen().joints - begin - way).cwiseAbs().maxCoeff() * GearedModel::kGear, 20 * kIncrement);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
  EXPECT_LT((rig.rack.shafts() - rig.seen().motors).cwiseAbs().maxCoeff(), 20 * kIncrement) << "the plant's position";
}

TEST_P(EveryMode, AxisAtRestIsNotStuck) {
  CanRig<Gantry> rig(GetParam());
  ASSERT_FALSE(rig.send(relative_joints((JointVector(4) << 0.0123, -0.0077, 0.02, 0.0001).finished(), 300)));
  rig.run(test::repetitions(Tick{12'000}));
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << describe(rig.seen().fault.code);
}

TEST_P(EveryMode, AxisThatReadsTheSameInMotionIsStuck) {
  for (const std::size_t axis : {0u, 1u, 3u}) {
    for (const double way : {0.05, 0.4}) {
      SCOPED_TRACE(testing::Message() << "axis " << axis << ", " << way << " rad");
      CanRig<Gantry> rig(GetParam());
      ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, way), 600)));
      rig.run(200);
      ASSERT_EQ(rig.seen().fault.code, ErrorCode::none);
      const double begin = rig.seen().desired.position[static_cast<Eigen::Index>(axis)];
      double end = begin;
      rig.rack.with([axis](auto& nodes) { nodes[axis].freeze(true); });
      for (int i = 0; i < 300 && rig.seen().fault.code == ErrorCode::none; ++i) {
        end = rig.seen().desired.position[static_cast<Eigen::Index>(axis)];
        rig.tick();
      }
      EXPECT_EQ(rig.seen().fault.code, ErrorCode::axis_stuck) << describe(rig.seen().fault.code);
      EXPECT_EQ(rig.seen().fault.axis, static_cast<int>(axis));
      const AxisParameters& parameters = rig.model.parameters().axes[axis];
      EXPECT_LE(std::abs(end - begin) * GearedModel::kGear,
                parameters.stuck_max + 2 * parameters.velocity_max * GearedModel::kGear * kCanPeriod);
    }
  }
}

TEST_P(EveryMode, RobotSwitchedOffInMotionIsStoppedByItsDrives) {
  CanRig<Gantry> rig(GetParam());
  rig.send(relative_joints(JointVector::Constant(4, 0.4), 600));
  rig.run(300);
  ASSERT_GT(rig.seen().joint_velocity.norm(), 0.1) << "the robot is moving";
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::operation_enabled);
  });
  rig.hardware.enable(false);
  rig.run(400);
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::switch_on_disabled);
  });
  const JointVector there = rig.rack.shafts();
  rig.run(20);
  EXPECT_EQ(rig.rack.shafts(), there);
}

INSTANTIATE_TEST_SUITE_P(Can, EveryMode,
                         testing::Values(DriveMode::cyclic_position, DriveMode::cyclic_velocity,
                                         DriveMode::cyclic_torque),
                         [](const auto& each) {
                           return std::string(each.param == DriveMode::cyclic_position   ? "Position"
                                              : each.param == DriveMode::cyclic_velocity ? "Velocity"
                                                                                         : "Torque");
                         });

TEST(CanHardware, EmergencyStopEndsTheSwitchingOn) {
  CanRig<Gantry> rig(DriveMode::cyclic_position);
  rig.servo.use_emergency_stop(rig.operators);
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  rig.operators.press();
  rig.run(200);
  rig.operators.reset();
  rig.rack.with([](auto& nodes) { nodes[2].hold_back(true); });
  ASSERT_FALSE(rig.send(recover));
  rig.run(50);
  rig.rack.with([](auto& nodes) { EXPECT_EQ(nodes[0].state(), DriveState::switched_on); });
  rig.operators.press();
  rig.run(10);
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::switch_on_disabled);
    nodes[2].hold_back(false);
  });
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::emergency_stop);
  rig.operators.reset();
  ASSERT_FALSE(rig.send(recover));
  rig.run(100);
  EXPECT_TRUE(rig.seen().enabled());
}

TEST_P(EveryMode, ReversedCounterAndOtherUnitsBehaveTheSame) {
  config::DriveTable table = table_for(Gantry{}.parameters(), GetParam());
  table.drives[1].units_per_turn = table.drives[1].velocity_units_per_turn = -4000;
  table.drives[2].units_per_turn = 65536;
  table.drives[2].velocity_units_per_turn = 600;  // a tenth of a revolution per minute
  table.drives[3].units_per_turn = -1000;
  table.drives[3].velocity_units_per_turn = -100000;
  CanRig<Gantry> rig(table, true);
  const JointVector begin = rig.seen().joints;
  const JointVector way = JointVector::Constant(4, 0.1);
  rig.send(relative_joints(way, 400));
  rig.run(500);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << describe(rig.seen().fault.code);
  EXPECT_LT((rig.seen().joints - begin - way).cwiseAbs().maxCoeff() * GearedModel::kGear, 60 * kIncrement);
}

TEST_P(EveryMode, NoAxisIsReleasedBeforeAllDrivesAreReady) {
  HeldGantry rig(GetParam());
  rig.hardware->open();
  rig.rack.with([](auto& nodes) { nodes[2].hold_back(true); });
  rig.hardware->enable(true);
  rig.after_tick = [&rig] {
    rig.rack.with([](auto& nodes) {
      if (nodes[2].state() != DriveState::ready_to_switch_on) return;
      for (const sim::DriveNode& node : nodes) EXPECT_FALSE(node.powered());
    });
  };
  rig.run(100);
  EXPECT_TRUE(rig.hardware->busy());
  rig.rack.with([](auto& nodes) {
    EXPECT_EQ(nodes[0].state(), DriveState::switched_on);
    nodes[2].hold_back(false);
  });
  rig.run(20);
  EXPECT_FALSE(rig.hardware->busy());
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::operation_enabled);
    nodes[2].hold_back(true);
  });
  // the error names the drive that is not ready in time, not the drives that wait for it
  rig.hardware->enable(false);
  rig.run(100);
  rig.hardware->enable(true);
  rig.run(1100);
  EXPECT_EQ(rig.input.fault, ErrorCode::drive_not_ready);
  EXPECT_EQ(rig.input.fault_axis, 2);
}

TEST(CanHardware, LateModeDisplayDelaysTheSwitchingOn) {
  HeldGantry rig;
  rig.hardware->open();
  rig.rack.with([](auto& nodes) { nodes[2].stay_in(DriveMode{1}); });
  rig.hardware->enable(true);
  rig.run(500);
  EXPECT_TRUE(rig.hardware->busy());
  EXPECT_EQ(rig.input.fault, ErrorCode::none);
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_FALSE(node.powered()) << "no brake is released";
    nodes[2].stay_in({});
  });
  rig.run(10);
  EXPECT_FALSE(rig.hardware->busy());
  EXPECT_EQ(rig.input.fault, ErrorCode::none);
  // the error names a drive that never reports the mode
  rig.hardware->enable(false);
  rig.run(100);
  rig.rack.with([](auto& nodes) { nodes[2].stay_in(DriveMode{1}); });
  rig.hardware->enable(true);
  rig.run(1100);
  EXPECT_FALSE(rig.hardware->busy());
  EXPECT_EQ(rig.input.fault, ErrorCode::drive_not_ready);
  EXPECT_EQ(rig.input.fault_axis, 2);
  EXPECT_EQ(describe(rig.input.fault_detail), describe(DriveFault(WrongMode{1, DriveMode{8}})));
}

TEST(CanHardware, DrivesWithoutAModeDisplayAreAccepted) {
  const config::DriveTable table = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  config::DriveTable there = table;
  there.eds = changed_eds("[6061]", "[6f61]");
  for (const config::DriveTable& reported : {table, there}) {
    HeldGantry rig(reported, there);
    rig.hardware->open();
    rig.hardware->enable(true);
    rig.run(50);
    EXPECT_FALSE(rig.hardware->busy());
    rig.run(1100);
    EXPECT_EQ(rig.input.fault, ErrorCode::none);
  }
}

/// The drive monitors the master's heartbeat from the first one on: before that nothing would stop it when this process
/// dies.
TEST(CanHardware, RestartedDriveReceivesAHeartbeatBeforeItGetsPower) {
  config::DriveTable table = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  table.heartbeat = 10;
  HeldGantry rig(table);
  rig.hardware->open();
  rig.run(20);
  rig.rack.with([](auto& nodes) { nodes[1].boot(1); });
  rig.run(5);
  EXPECT_EQ(rig.input.fault, ErrorCode::drive_restarted);
  std::vector<can::Frame> heard;
  const auto ear = rig.bus.open();
  rig.after_tick = [&] {
    for (can::Frame frame; ear->receive(frame, 0);) heard.push_back(frame);
  };
  rig.hardware->reset_fault();
  for (int i = 0; i < 2000 && rig.hardware->busy(); ++i) rig.run(1);
  rig.run(5);
  const auto start = std::find(heard.begin(), heard.end(), canopen::nmt_frame(canopen::NmtCommand::start, 2));
  ASSERT_NE(start, heard.end());
  const auto next = std::find_if(start, heard.end(), [&table](const can::Frame& frame) {
    return frame.id == canopen::kHeartbeat + table.master || frame.id == canopen::kReceivePdo1 + 2;
  });
  ASSERT_NE(next, heard.end());
  EXPECT_EQ(*next, canopen::heartbeat_frame(table.master, canopen::NmtState::operational));
}

/// A lost single drive cannot be distinguished from a cut bus.
TEST(CanHardware, LostOnlyDriveOfARobotIsNamed) {
  CanRig<Slide> rig(DriveMode::cyclic_position);
  ASSERT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  rig.rack.with([](auto& nodes) { nodes[0].cut(true); });
  rig.run(10);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::hardware_silent);
  EXPECT_EQ(rig.seen().fault.axis, 0);
}

TEST(CanHardware, EndOfTheProcessLeavesNoDriveWithPower) {
  HeldGantry rig;
  rig.hardware->open();
  rig.hardware->enable(true);
  rig.run(20);
  EXPECT_FALSE(rig.hardware->busy()) << "they are on";
  rig.hardware.reset();
  const auto powered = [&rig] {
    bool any = false;
    rig.rack.with([&any](auto& nodes) {
      for (const sim::DriveNode& node : nodes) any = any || node.powered();
    });
    return any;
  };
  for (int i = 0; i < 5000 && powered(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_FALSE(powered());
  // a second master finds the drives in any state
  rig.connect();
  rig.hardware->open();
  EXPECT_FALSE(powered());
}

}  // namespace
}  // namespace mrroc::edp
