#include "config/drives/drive_table.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "config/drives/drive_table_fixture.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc::config::drive_table_test {
namespace {

namespace fs = std::filesystem;
using canopen::DriveMode;
using canopen::Object;

TEST_F(DriveTableTest, MostKeysAreOptional) {
  const DriveTable drives = read(table());
  EXPECT_EQ(drives.file, scratch_.path() / "crane_drives.toml");
  EXPECT_EQ(drives.mode, DriveMode::cyclic_position);
  EXPECT_FALSE(drives.absolute_encoders);
  EXPECT_EQ(drives.master, 127);
  EXPECT_EQ(drives.heartbeat, 0.1);
  EXPECT_EQ(drives.answer_time, 0.5);
  EXPECT_EQ(drives.missed_max, 2);
  EXPECT_EQ(drives.switch_on_time, 2);
  EXPECT_TRUE(drives.target_at_sync);
  EXPECT_EQ(drives.status_every, 4);
  EXPECT_EQ(drives.eds.product(), "CiA 402 servo drive");
  ASSERT_EQ(drives.drives.size(), 3u);
  const DriveEntry& column = drives.drives[0];
  EXPECT_EQ(column.axis, "column");
  EXPECT_EQ(column.node, 1);
  EXPECT_EQ(column.units_per_turn, 4000);
  EXPECT_EQ(column.velocity_units_per_turn, 4000);
  EXPECT_EQ(column.rated_current, 10);
  EXPECT_EQ(column.position_gain, 0);
  EXPECT_TRUE(column.settings.empty());
}

TEST_F(DriveTableTest, ReadsEveryKey) {
  const std::string gain = "position_gain = 30\n";
  const DriveTable drives = read(
      "eds = 'drive.eds'\nmode = 'velocity'\nabsolute_encoders = true\nmaster = 100\nheartbeat = 0.25\n"
      "answer_time = 0.75\nmissed_max = 5\nswitch_on_time = 4.5\nset_points = 'at once'\nstatus_every = 10\n" +
      drive("column", 1, gain) + drive("arm", 2, gain) +
      drive("belt", 3,
            "units_per_turn = 65536\nvelocity_units_per_turn = 600\nreversed = true\nposition_gain = 40\nhoming_method "
            "= 17\n"
            "homing_speed_switch = 12\nhoming_speed_zero = 1.5\n"));
  EXPECT_EQ(drives.mode, DriveMode::cyclic_velocity);
  EXPECT_TRUE(drives.absolute_encoders);
  EXPECT_EQ(drives.master, 100);
  EXPECT_EQ(drives.heartbeat, 0.25);
  EXPECT_EQ(drives.answer_time, 0.75);
  EXPECT_EQ(drives.missed_max, 5);
  EXPECT_EQ(drives.switch_on_time, 4.5);
  EXPECT_FALSE(drives.target_at_sync);
  EXPECT_EQ(drives.status_every, 10);
  EXPECT_EQ(drives.drives[0].position_gain, 30);
  const DriveEntry& belt = drives.drives[2];
  EXPECT_EQ(belt.units_per_turn, -65536);
  EXPECT_EQ(belt.velocity_units_per_turn, -600);
  EXPECT_EQ(belt.position_gain, 40);
  EXPECT_EQ(belt.homing.method, 17);
  EXPECT_EQ(belt.homing.speed_switch, 12);
  EXPECT_EQ(belt.homing.speed_zero, 1.5);
}

TEST_F(DriveTableTest, HomingDefaultsToThatOfTheAxis) {
  const DriveTable drives = read(table());
  EXPECT_EQ(drives.drives[0].homing.method, 5);  // its switch is closed up to the negative end
  EXPECT_EQ(drives.drives[0].homing.speed_switch, 15);
  EXPECT_EQ(drives.drives[0].homing.speed_zero, 3.5);
  EXPECT_EQ(drives.drives[1].homing.method, 3);
  EXPECT_EQ(drives.drives[1].homing.speed_switch, 20);
  EXPECT_EQ(drives.drives[1].homing.speed_zero, 2);
  EXPECT_EQ(drives.drives[2].homing.method, 0) << "without a switch it has no method";
  EXPECT_EQ(read(table("", "homing_method = -3\n")).drives[0].homing.method, -3);
  EXPECT_EQ(read(table("", "reversed = true\n")).drives[0].homing.method, 3)
      << "methods follow the drive's direction of counting";
}

TEST_F(DriveTableTest, LoopClosedByTheEdpGetsItsSetPointsAtOnce) {
  EXPECT_FALSE(read(table("", "", "torque")).target_at_sync);
  EXPECT_TRUE(read(table("set_points = 'at sync'\n", "", "torque")).target_at_sync);
}

TEST_F(DriveTableTest, SettingsAreNamedAsInTheEdsFileOrByAddress) {
  const DriveTable drives = read(table("[objects]\n'Max torque' = 1500\n'0x6065' = 4000\n",
                                       "[drives.objects]\n'homing acceleration' = 70000\n"
                                       "'Software position limit/Min position limit' = -900\n'0x607D:2' = 900\n"
                                       "'max torque' = 800\n"));
  const std::vector<NodeSetting>& own = drives.drives[0].settings;
  ASSERT_EQ(own.size(), 6u);  // those of all drives first, each in the order of the file
  EXPECT_EQ(own[0].object, (Object{0x6072}));
  EXPECT_EQ(own[0].name, "Max torque");
  EXPECT_EQ(own[0].value, 1500);
  EXPECT_EQ(own[0].size, 2);
  EXPECT_EQ(own[1].object, (Object{0x6065}));
  EXPECT_EQ(own[1].size, 4);
  EXPECT_EQ(own[2].object, (Object{0x609a}));
  EXPECT_EQ(own[3].object, (Object{0x607d, 1}));
  EXPECT_EQ(own[3].value, -900);
  EXPECT_EQ(own[4].object, (Object{0x607d, 2}));
  EXPECT_EQ(own[5].object, (Object{0x6072}));  // the drive's own comes last and takes effect
  EXPECT_EQ(own[5].value, 800);
  EXPECT_EQ(drives.drives[1].settings.size(), 2u);
}

/// Objects of the profile are given as those of the first axis.
TEST_F(DriveTableTest, ReadsSeveralAxesOfADrive) {
  fs::copy_file(scratch_.path() / "drive.eds", scratch_.path() / "cia402.eds");
  const DriveTable table = read("eds = 'cia402.eds'\nmode = 'position'\n[objects]\n'0x6072' = 1500\n'0x1006' = 2000\n" +
                                drive("column", 4) + drive("arm", 4, "channel = 2\n[drives.objects]\n'0x6065' = 9\n") +
                                drive("belt", 4, "channel = 4\nfirst_pdo = 7\npdo_node = 20\n"));
  ASSERT_EQ(table.drives.size(), 3u);
  EXPECT_EQ(table.nodes(), 1u);
  EXPECT_TRUE(table.is_first_of_node(table.drives[0]));
  EXPECT_FALSE(table.is_first_of_node(table.drives[1]));
  const DriveEntry &arm = table.drives[1], &belt = table.drives[2];
  EXPECT_EQ(arm.channel, 2);
  EXPECT_EQ(arm.first_pdo, 65);
  EXPECT_EQ(arm.pdo_node(), 5);
  ASSERT_EQ(arm.settings.size(), 2u);
  EXPECT_EQ(arm.settings[0].object, (canopen::Object{0x6872}));
  EXPECT_EQ(arm.settings[1].object, (canopen::Object{0x6865}));
  EXPECT_EQ(belt.first_pdo, 7);
  EXPECT_EQ(belt.pdo_node(), 20);
  EXPECT_EQ(table.drives[0].settings.size(), 2u);
  EXPECT_NE(table.eds.find({0x7840}), nullptr);
  EXPECT_NE(table.eds.find({0x1806, 1}), nullptr);
}

TEST_F(DriveTableTest, DrivesAreInTheOrderOfTheAxes) {
  const DriveTable drives =
      read("eds = 'drive.eds'\nmode = 'torque'\n" + drive("belt", 7) + drive("column", 9) + drive("arm", 8));
  ASSERT_EQ(drives.drives.size(), 3u);
  EXPECT_EQ(drives.drives[0].node, 9);
  EXPECT_EQ(drives.drives[1].node, 8);
  EXPECT_EQ(drives.drives[2].node, 7);
}

TEST_F(DriveTableTest, FindsTheFrameworksEdsFileInEveryShare) {
  const task_test::ScratchFolder framework;
  framework.write("canopen/standard/general.eds", "");
  fs::copy_file(scratch_.path() / "drive.eds", framework.path() / "canopen/standard/general.eds",
                fs::copy_options::overwrite_existing);
  setenv("MRROC_SHARE", ("/nowhere:" + framework.path().string()).c_str(), 1);
  EXPECT_EQ(read(table().replace(7, 9, "general.eds")).eds.product(), "CiA 402 servo drive");
  unsetenv("MRROC_SHARE");
}

}  // namespace
}  // namespace mrroc::config::drive_table_test
