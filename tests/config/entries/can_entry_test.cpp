#include <gtest/gtest.h>

#include "config/deployment_fixture.hpp"
#include "config/description.hpp"
#include "config/drives/drive_table.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc::config::can_entry_test {
namespace {

class CanEntryTest : public DeploymentFixture {
 protected:
  CanEntryTest() : DeploymentFixture("valid") { scratch_.write("scene.xml", ""); }

  /// An IRb-6 on a bus; `general` are lines of [deployment], `robot` of [robots.arm], `can` of [robots.arm.can].
  Deployment load(const std::string& can, const std::string& robot = "", const std::string& general = "") const {
    return load_deployment(scratch_.write(
        "cell/d.toml", "[deployment]\nname = 'one'\nclock = 'real'\n" + general +
                           "[sim]\nscene = '../scene.xml'\n[robots.arm]\ntype = 'irb6'\nhardware = 'socketcan'\n" +
                           robot + "[robots.arm.can]\n" + can));
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(CanEntryTest, RealDrivesUseTheTableOfTheType) {
  const Deployment deployment = load("interface = 'can0'\n");
  const RobotEntry& arm = deployment.robot("arm");
  ASSERT_TRUE(arm.can);
  EXPECT_EQ(arm.can->interface, "can0");
  EXPECT_EQ(arm.can->drives, MRROC_SOURCE_DIR "/tests/config/share/robots/irb6/irb6_drives.toml");
  EXPECT_FALSE(arm.driver.simulated);
  EXPECT_EQ(arm.driver.stand_in, "");
  EXPECT_FALSE(arm.in_world());
  EXPECT_FALSE(arm.synchronised);  // its encoders count from their position at power-on
}

TEST_F(CanEntryTest, SimulatedDrivesHaveAProgramAndMayStartSynchronised) {
  const Deployment deployment = load("interface = 'can0'\nsimulated = true\n");
  const RobotEntry& arm = deployment.robot("arm");
  EXPECT_TRUE(arm.driver.simulated);
  EXPECT_EQ(arm.driver.stand_in, program("irb6_drives"));
  EXPECT_TRUE(arm.in_world());
  EXPECT_TRUE(arm.synchronised);
  EXPECT_FALSE(load("interface = 'can0'\nsimulated = true\n", "synchronised = false\n").robot("arm").synchronised);
}

TEST_F(CanEntryTest, DeploymentMayHaveItsOwnTable) {
  scratch_.write("cell/cabinet.toml", "eds = '" MRROC_SOURCE_DIR
                                      "/src/canopen/cia402.eds'\nmode = 'torque'\nabsolute_encoders = true\n"
                                      "[[drives]]\naxis = 'column'\nnode = 11\nrated_current = 6\n");
  const Deployment deployment = load("interface = 'can0'\ndrives = 'cabinet.toml'\n", "synchronised = true\n");
  EXPECT_EQ(deployment.robot("arm").can->drives, scratch_.path() / "cell/cabinet.toml");
  EXPECT_TRUE(deployment.robot("arm").synchronised);
}

TEST_F(CanEntryTest, ReportsAnErrorInTheTableWithItsFile) {
  scratch_.write("cell/cabinet.toml", "eds = 'none.eds'\nmode = 'torque'\n");
  EXPECT_EQ(message_of(scratch_.path() / "cell", [&] { load("interface = 'can0'\ndrives = 'cabinet.toml'\n"); }),
            "cabinet.toml:1: eds: 'none.eds' is not there, expected an EDS file beside this one, or 'cia402.eds'");
}

TEST_F(CanEntryTest, HubIsBesideTheDeploymentFile) {
  EXPECT_EQ(load("interface = 'unix:hub'\n").robot("arm").can->interface,
            "unix:" + (scratch_.path() / "cell/hub").string());
  EXPECT_EQ(load("interface = 'unix:/run/hub'\n").robot("arm").can->interface, "unix:/run/hub");
}

TEST_F(CanEntryTest, DeploymentMayHaveIoNodes) {
  const std::string io = MRROC_SOURCE_DIR "/tests/config/valid/cell_io.toml";
  const Deployment deployment = load("interface = 'can0'\nio = '" + io + "'\n", "emergency_stop = 2\n");
  EXPECT_EQ(deployment.robot("arm").can->io, io);
  EXPECT_EQ(deployment.robot("arm").emergency_stop, 2);
  EXPECT_NE(describe(deployment).find(" and the I/O nodes of " + io + ": ECP"), std::string::npos);
}

TEST_F(CanEntryTest, DescriptionNamesBusAndDrives) {
  const std::string text = replaced(
      replaced(describe(load("interface = 'can0'\nsimulated = true\n")), programs_.path().string(), "PROGRAMS"),
      MRROC_SOURCE_DIR, "SOURCE");
  EXPECT_NE(text.find("  arm  irb6 on socketcan can0 with the drives of SOURCE/tests/config/share/robots/irb6/"
                      "irb6_drives.toml: ECP PROGRAMS/mrroc_ecp, EDP PROGRAMS/irb6_edp, simulated drives "
                      "PROGRAMS/irb6_drives\n"),
            std::string::npos)
      << text;
}

TEST_F(CanEntryTest, SimulatedDrivesCountAsProcesses) {
  std::string text = "deployment.name = 'crowd'\nsim.scene = 'scene.xml'\n";
  for (int i = 0; i < 16; ++i) {
    const std::string number = std::to_string(i);
    text += "[robots.r" + number + "]\ntype = 'irb6'\nhardware = 'socketcan'\ncan = { interface = 'can" + number +
            "', simulated = true }\n";
  }
  for (int i = 0; i < 11; ++i) text += "[sensors.s" + std::to_string(i) + "]\ntype = 'force_torque'\n";
  const auto file = scratch_.write("d.toml", text);
  EXPECT_EQ(message_of(scratch_.path(), [&] { load_deployment(file); }),
            "d.toml:1: 61 processes (two per robot, one more with simulated drives, one per sensor, the MP, the "
            "simulator), expected at most 60");
}

/// Every robot type of the project has a nominal table, with nodes from 1. Drives with incremental encoders need
/// switches for the synchronisation.
TEST(RobotDrives, EveryTypeHasAValidTable) {
  setenv("MRROC_SHARE", MRROC_BINARY_DIR "/share/mrroc", 1);
  EXPECT_GE(robot_types().size(), 8u);
  for (const std::string& type : robot_types()) {
    SCOPED_TRACE(type);
    const RobotParameters robot = read_robot_parameters(Table::load(type_file("robots", type, type + ".toml")));
    const DriveTable table = read_drive_table(type_file("robots", type, type + "_drives.toml"), robot);
    bool switches = true;
    for (std::size_t i = 0; i < robot.axes.size(); ++i) {
      EXPECT_EQ(table.drives[i].node, i + 1);
      switches = switches && robot.axes[i].synchro_coarse != 0;
    }
    EXPECT_EQ(table.absolute_encoders, !switches);
  }
  unsetenv("MRROC_SHARE");
}

/// An IRb-6 and a second robot on its bus, whose table of drives begins with `general`.
class SharedBusTest : public CanEntryTest {
 protected:
  std::string refusal(const std::string& general, int node, const std::string& io = "") {
    scratch_.write("cell/second.toml", "eds = '" MRROC_SOURCE_DIR "/src/canopen/cia402.eds'\nmode = 'torque'\n" +
                                           std::string("absolute_encoders = true\n") + general +
                                           "[[drives]]\naxis = 'belt'\nnode = " + std::to_string(node) +
                                           "\nrated_current = 6\n");
    if (!io.empty())
      scratch_.write("cell/io.toml", "[[nodes]]\nnode = " + io +
                                         "\neds = '" MRROC_SOURCE_DIR "/src/canopen/cia401.eds'\ndigital_inputs = 8\n");
    return message_of(scratch_.path() / "cell", [&] {
      load(
          "interface = 'can0'\n[robots.belt]\ntype = 'conveyor'\nhardware = 'socketcan'\n"
          "[robots.belt.can]\ninterface = 'can0'\ndrives = 'second.toml'\n" +
          std::string(io.empty() ? "" : "io = 'io.toml'\n"));
    });
  }
};

TEST_F(SharedBusTest, RobotsWithTheirOwnNumbersShareABus) { EXPECT_EQ(refusal("master = 126\nsync = 0xfe\n", 7), ""); }

TEST_F(SharedBusTest, RefusesANumberOfAnotherRobotWithItsLine) {
  const std::string expected = " on the same bus, expected a unique number on the bus, in a table for robot 'belt'";
  EXPECT_EQ(refusal("master = 126\nsync = 0xfe\n", 1),
            "second.toml:8: drives[0].node: 1 is the drive of 'column' of robot 'arm'" + expected);
  EXPECT_EQ(refusal("master = 126\nsync = 0xfe\n", 127),
            "second.toml:8: drives[0].node: 127 is the master of robot 'arm'" + expected);
  EXPECT_EQ(refusal("master = 127\nsync = 0xfe\n", 7),
            "second.toml:4: master: 127 is the master of robot 'arm'" + expected);
  EXPECT_EQ(refusal("master = 126\nsync = 0xfe\n", 7, "1"),
            "io.toml:2: nodes[0].node: 1 is the drive of 'column' of robot 'arm'" + expected);
}

TEST_F(SharedBusTest, RefusesASyncOfAnotherRobotOrAnEmcy) {
  EXPECT_EQ(refusal("sync = 128\nmaster = 126\n", 7),
            "second.toml:4: sync: 128 is the SYNC of robot 'arm' on the same bus, expected a unique identifier on the "
            "bus, as 128 plus the key 'master'");
  EXPECT_EQ(
      refusal("sync = 0x81\nmaster = 126\n", 7),
      "second.toml:4: sync: 129 of robot 'belt' is the identifier of the EMCY of node 1 on the same bus, expected "
      "a unique identifier on the bus, as 128 plus the key 'master'");
  EXPECT_EQ(
      refusal("sync = 0x87\nmaster = 126\n", 7),
      "second.toml:8: drives[0].node: 7, whose EMCY has the identifier of the table's 'sync', expected another one");
}

TEST_F(SharedBusTest, RefusesABitRateThatTheFramesDoNotFit) {
  const auto message = [this](const std::string& rate) {
    return message_of(scratch_.path() / "cell", [&] { load("interface = 'can0'\nbit_rate = " + rate + "\n"); });
  };
  EXPECT_EQ(message("250000"), "");
  EXPECT_EQ(message("125000"),
            "d.toml:11: robots.arm.can.bit_rate: 125000 is too slow: at a servo period of 0.002 s the frames of 1 axis "
            "take up to 225000 bit/s, expected 250000, or fewer axes on the bus or a longer servo_period");
  EXPECT_EQ(message("100000"),
            "d.toml:11: robots.arm.can.bit_rate: 100000 is not a bit rate of CiA 301, expected 10000, 20000, 50000, "
            "125000, 250000, 500000, 800000 or 1000000");
}

}  // namespace
}  // namespace mrroc::config::can_entry_test
