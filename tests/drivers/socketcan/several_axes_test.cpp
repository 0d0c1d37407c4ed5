// Drives with several axes: one node, its axes at + 800h and with PDOs of their own.
#include <gtest/gtest.h>

#include <set>

#include "canopen/emergency.hpp"
#include "drivers/socketcan/can_rig.hpp"
#include "drivers/socketcan/drive_setup.hpp"

namespace mrroc::edp::several_axes_test {
namespace {

using namespace canopen;

/// The gantry with two drives of two axes: nodes 1 and 11. The last two axes are exchanged: the first in the axes'
/// order is not the first of its node.
config::DriveTable two_drives(DriveMode mode) {
  config::DriveTable table = table_for(Gantry{}.parameters(), mode);
  const std::array<std::pair<int, int>, 4> places{{{1, 1}, {1, 2}, {11, 3}, {11, 1}}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    config::DriveEntry& drive = table.drives[i];
    drive.node = static_cast<NodeId>(places[i].first);
    drive.channel = places[i].second;
    drive.first_pdo = first_pdo_of_channel(drive.channel);
    drive.pdos_of = static_cast<NodeId>(drive.node + drive.channel - 1);
    if (drive.channel != 1) table.eds.repeat_axis(drive.channel, drive.first_pdo);
  }
  return table;
}

constexpr double kTurnOfIncrement = 2 * std::numbers::pi / 4000;  // rad

class SeveralAxes : public testing::TestWithParam<DriveMode> {};

TEST_P(SeveralAxes, MoveAsDrivesOfTheirOwnDo) {
  const auto moved = [](const config::DriveTable& drives) {  // one robot after the other: there may be one bus
    CanRig<Gantry> rig(drives, true);
    EXPECT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
    rig.send(relative_joints(JointVector{{0.1, -0.1, 0.05, 0.08}}, 400));
    rig.run(500);
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << describe(rig.seen().fault.code);
    return rig.seen().joints;
  };
  const JointVector several = moved(two_drives(GetParam()));
  const JointVector single = moved(table_for(Gantry{}.parameters(), GetParam()));
  EXPECT_LT((several - single).cwiseAbs().maxCoeff() * GearedModel::kGear, 5 * kTurnOfIncrement);
}

TEST_P(SeveralAxes, RestartOfADriveIsOneOfAllItsAxes) {
  HeldGantry rig(two_drives(GetParam()));
  ASSERT_EQ(rig.refusal(), "");
  rig.hardware->enable(true);
  rig.run(100);
  ASSERT_EQ(rig.input.fault, ErrorCode::none)
      << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
  for (const std::size_t first : {0u, 2u}) {
    rig.rack.with([first](auto& nodes) {
      for (const std::size_t i : {first, first + 1}) nodes[i].boot(0);
    });
    rig.run(20);
    EXPECT_EQ(rig.input.fault, ErrorCode::drive_restarted)
        << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
    EXPECT_EQ(rig.input.fault_axis, static_cast<int>(first));
    rig.hardware->enable(false);
    rig.run(20);
    rig.hardware->reset_fault();
    rig.run(900);
    EXPECT_FALSE(rig.hardware->busy());
    EXPECT_EQ(rig.input.fault, ErrorCode::none)
        << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
    rig.hardware->enable(true);
    rig.run(100);
    EXPECT_EQ(rig.input.fault, ErrorCode::none)
        << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
    rig.rack.with([](auto& nodes) {
      for (const sim::DriveNode& node : nodes) EXPECT_TRUE(node.powered());
    });
  }
}

TEST_P(SeveralAxes, FaultIsOfTheAxisThatHasIt) {
  for (const int axis : {0, 1, 2, 3}) {
    HeldGantry rig(two_drives(GetParam()));
    ASSERT_EQ(rig.refusal(), "");
    rig.hardware->enable(true);
    rig.run(100);
    bool seen = false;
    rig.after_tick = [&] {
      if (rig.input.fault == ErrorCode::none) return;
      seen = true;
      EXPECT_EQ(rig.input.fault, ErrorCode::drive_fault);
      EXPECT_EQ(rig.input.fault_axis, axis)
          << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
    };
    rig.rack.with([axis](auto& nodes) { nodes[static_cast<std::size_t>(axis)].fail(0x7305); });
    rig.run(50);
    EXPECT_TRUE(seen);
    rig.after_tick = {};
    rig.hardware->enable(false);
    rig.run(20);
    rig.hardware->reset_fault();
    rig.run(50);
    EXPECT_EQ(rig.input.fault, ErrorCode::none)
        << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, SeveralAxes,
                         testing::Values(DriveMode::cyclic_position, DriveMode::cyclic_velocity,
                                         DriveMode::cyclic_torque));

/// An error of the whole drive, as of its supply, stops the robot though no axis reports it.
TEST(SeveralAxesOfADrive, EmergencyThatNoAxisReportsIsAFault) {
  HeldGantry rig(two_drives(DriveMode::cyclic_position));
  ASSERT_EQ(rig.refusal(), "");
  rig.hardware->enable(true);
  rig.run(100);
  const auto other = rig.bus.open();
  other->send(to_frame({1, 0x3210, 0, {}}));
  rig.run(50);
  EXPECT_EQ(rig.input.fault, ErrorCode::drive_fault);
  EXPECT_EQ(rig.input.fault_axis, 0);
}

TEST(SeveralAxesOfADrive, SettingsAreThoseOfEachAxisAndOnceThoseOfTheNode) {
  const config::DriveTable table = two_drives(DriveMode::cyclic_position);
  const std::vector<config::NodeSetting> settings = node_settings(table, table.drives[0], 0.002);
  EXPECT_TRUE(node_settings(table, table.drives[1], 0.002).empty());
  std::set<Object> written;
  int heartbeats = 0;
  for (const config::NodeSetting& setting : settings) {
    heartbeats += setting.object == kProducerHeartbeat ? 1 : 0;
    written.insert(setting.object);
    EXPECT_NE(table.eds.find(setting.object), nullptr) << setting.name;
    if (setting.object == Object{0x1640, 1}) {
      EXPECT_EQ(setting.value, 0x68400010);
    } else if (setting.object == Object{0x1a41, 2}) {
      EXPECT_EQ(setting.value, 0x68fd0020);
    } else if (setting.object == Object{0x1440, 1}) {
      EXPECT_EQ(setting.value & 0x7ff, 0x202);
    }
  }
  EXPECT_EQ(heartbeats, 1);
  for (const Object object : {Object{0x6060}, Object{0x6860}, Object{0x1400, 1}, Object{0x1440, 1}, Object{0x1841, 2}})
    EXPECT_TRUE(written.contains(object)) << to_text(object);
}

/// Two PDOs after one another, as drives with few of them have.
TEST(SeveralAxesOfADrive, MayHaveTheirPdosAnywhere) {
  config::DriveTable table = table_for(Gantry{}.parameters(), DriveMode::cyclic_velocity);
  for (std::size_t i = 0; i < 4; ++i) {
    config::DriveEntry& drive = table.drives[i];
    drive.pdos_of = drive.node;
    drive.node = 1;
    drive.channel = static_cast<int>(i) + 1;
    drive.first_pdo = 1 + 2 * static_cast<int>(i);
    if (drive.channel != 1) table.eds.repeat_axis(drive.channel, drive.first_pdo);
  }
  HeldGantry rig(table);
  ASSERT_EQ(rig.refusal(), "");
  rig.hardware->enable(true);
  rig.run(200);
  EXPECT_EQ(rig.input.fault, ErrorCode::none)
      << describe(rig.input.fault) << " " << describe(rig.input.fault_detail).view();
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_TRUE(node.powered());
  });
}

TEST(SeveralAxesOfADrive, RefusalNamesTheAxis) {
  config::DriveTable wanted = two_drives(DriveMode::cyclic_position), there = wanted;
  wanted.drives[1].settings.push_back({of_channel(kFollowingErrorWindow, 2), "window", 7, 1});  // its size is 4
  HeldGantry rig(wanted, there);
  EXPECT_NE(rig.refusal().find("node 1: refuses window = 7"), std::string::npos);
}

}  // namespace
}  // namespace mrroc::edp::several_axes_test
