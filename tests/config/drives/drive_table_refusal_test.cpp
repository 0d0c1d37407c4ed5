#include "config/drives/drive_table_fixture.hpp"

namespace mrroc::config::drive_table_refusal_test {
namespace {

TEST_F(DriveTableTest, ReportsAMisspeltKeyFirst) {
  EXPECT_EQ(message(table("heartbeet = 0.1\n")),
            "crane_drives.toml:3: heartbeet: unknown key, did you mean 'heartbeat'?");
  EXPECT_EQ(message(table("", "nod = 4\n")), "crane_drives.toml:7: drives[0].nod: unknown key, did you mean 'node'?");
  EXPECT_EQ(message("eds = 'drive.eds'\nmode = 'position'\n[[drives]]\naxis = 'column'\nnode = 1\nrated_curent = 10\n"),
            "crane_drives.toml:6: drives[0].rated_curent: unknown key, did you mean 'rated_current'?");
  EXPECT_EQ(
      message(table("", "homing = 3\n")),
      "crane_drives.toml:7: drives[0].homing: unknown key, expected 'axis', 'channel', 'first_pdo', 'homing_method', "
      "'homing_speed_switch', 'homing_speed_zero', 'node', 'objects', 'pdo_node', 'position_gain', 'rated_current', "
      "'reversed', 'units_per_turn' or 'velocity_units_per_turn'");
}

TEST_F(DriveTableTest, RefusesMissingKeys) {
  EXPECT_EQ(message(""), "crane_drives.toml:1: mode: missing, expected 'position', 'velocity' or 'torque'");
  EXPECT_EQ(message("mode = 'position'\n"), "crane_drives.toml:1: eds: missing, expected a text");
  EXPECT_EQ(message("eds = 'drive.eds'\nmode = 'position'\n"),
            "crane_drives.toml:1: drives: no drive of axis 'column', expected one for each axis");
  EXPECT_EQ(message(table("[[drives]]\nnode = 5\n")),
            "crane_drives.toml:3: drives[0].axis: missing, expected 'column', 'arm' or 'belt'");
  EXPECT_EQ(message("eds = 'drive.eds'\nmode = 'position'\n[[drives]]\naxis = 'column'\n[[drives]]\naxis = 'arm'\n"
                    "[[drives]]\naxis = 'belt'\n"),
            "crane_drives.toml:3: drives[0].node: missing, expected an integer from 1 to 127");
  EXPECT_EQ(message("eds = 'drive.eds'\nmode = 'position'\n[[drives]]\naxis = 'column'\nnode = 1\n[[drives]]\n"
                    "axis = 'arm'\n[[drives]]\naxis = 'belt'\n"),
            "crane_drives.toml:3: drives[0].rated_current: missing, expected a number from 0.001 to 10000");
  EXPECT_EQ(message(table("", "", "velocity")),
            "crane_drives.toml:3: drives[0].position_gain: missing, expected a number from 0 to 10000");
}

TEST_F(DriveTableTest, RefusesUnknownWords) {
  EXPECT_EQ(message(table("", "", "speed")),
            "crane_drives.toml:2: mode: unknown value 'speed', expected 'position', 'velocity' or 'torque'");
  EXPECT_EQ(message(table("set_points = 'later'\n")),
            "crane_drives.toml:3: set_points: unknown value 'later', expected 'at sync' or 'at once'");
}

TEST_F(DriveTableTest, RefusesInvalidNumbers) {
  EXPECT_EQ(message(table("master = 128\n")),
            "crane_drives.toml:3: master: 128 is out of range, expected an integer from 1 to 127");
  EXPECT_EQ(message(table("heartbeat = 11\n")),
            "crane_drives.toml:3: heartbeat: 11 is out of range, expected a number from 0 to 10");
  EXPECT_EQ(message(table("heartbeat = 0.01\n")),
            "crane_drives.toml:3: heartbeat: 0.01 s is below a servo period, expected 0.02 to 10 s");
  EXPECT_EQ(
      message(table("heartbeat = 0\n")),
      "crane_drives.toml:3: heartbeat: 0, but without it drives continue when the EDP dies, expected 0.02 to 10 s");
  EXPECT_EQ(message(table("answer_time = 1\n")),
            "crane_drives.toml:3: answer_time: 1 is out of range, expected a number from 0.05 to 0.9");
  EXPECT_EQ(message(table("missed_max = -1\n")),
            "crane_drives.toml:3: missed_max: -1 is out of range, expected an integer from 0 to 100");
  EXPECT_EQ(message(table("switch_on_time = 0\n")),
            "crane_drives.toml:3: switch_on_time: 0 is out of range, expected a number from 0.1 to 60");
  EXPECT_EQ(message(table("sync = 0x100\n")),
            "crane_drives.toml:3: sync: 256 is out of range, expected an integer from 128 to 255");
  EXPECT_EQ(message(table("status_every = 0\n")),
            "crane_drives.toml:3: status_every: 0 is out of range, expected an integer from 1 to 240");
  EXPECT_EQ(message(table("", "units_per_turn = -4000\n")),
            "crane_drives.toml:7: drives[0].units_per_turn: -4000 is out of range, expected a number from 1 to 1e+09");
  EXPECT_EQ(message(table("", "units_per_turn = 1e8\n")),
            "crane_drives.toml:7: drives[0].units_per_turn: 1e+08 make the shaft's range longer than 32 bits, expected "
            "at most 26986075 for its motor_min and motor_max");
  EXPECT_EQ(message(table("", "velocity_units_per_turn = 0\n")),
            "crane_drives.toml:7: drives[0].velocity_units_per_turn: 0 is out of range, expected a number from 1 to "
            "1e+09");
  EXPECT_EQ(message(table("", "homing_speed_zero = 0.05\nvelocity_units_per_turn = 60\n")),
            "crane_drives.toml:7: drives[0].homing_speed_zero: 0.05 rad/s is less than half a velocity unit "
            "of the drive, expected at least 0.053 rad/s, or finer units");
  EXPECT_EQ(message(table("", "velocity_units_per_turn = 60\n")), "");
  EXPECT_EQ(message(table("", "homing_method = 0\n")),
            "crane_drives.toml:7: drives[0].homing_method: 0 is not a homing method of CiA 402, expected 1 to 14, 17 "
            "to 30, 33 to 35, "
            "37, or one of the maker's own below 0");
  EXPECT_EQ(message(table("", "homing_method = 38\n")),
            "crane_drives.toml:7: drives[0].homing_method: 38 is not a homing method of CiA 402, expected 1 to 14, 17 "
            "to 30, 33 to "
            "35, 37, or one of the maker's own below 0");
  EXPECT_EQ(message(table("", "homing_method = 300\n")),
            "crane_drives.toml:7: drives[0].homing_method: 300 is out of range, expected an integer from -128 to 127");
  EXPECT_EQ(message(table("", "homing_speed_switch = 16\n")),
            "crane_drives.toml:7: drives[0].homing_speed_switch: 16 is out of range, expected a number from 0 to 15");
  EXPECT_EQ(message(table("", "homing_speed_switch = 0\n")),
            "crane_drives.toml:7: drives[0].homing_speed_switch: 0, but homing method 5 moves the axis, expected a "
            "speed, rad/s");
  EXPECT_EQ(message(table("", "homing_method = 33\nhoming_speed_zero = 0\n")),
            "crane_drives.toml:8: drives[0].homing_speed_zero: 0, but homing method 33 moves the axis, expected a "
            "speed, rad/s");
  EXPECT_EQ(message(table("", "position_gain = 40\n")),
            "crane_drives.toml:7: drives[0].position_gain: a drive that gets no velocity, expected mode = "
            "\"velocity\", or no such key");
  EXPECT_EQ(message(table("", "reversed = 'yes'\n")),
            "crane_drives.toml:7: drives[0].reversed: 'yes' is a text, expected true or false");
}

TEST_F(DriveTableTest, DetectsARatedCurrentInMilliamperes) {
  const auto with = [&](const std::string& current) {
    return message("eds = 'drive.eds'\nmode = 'position'\n[[drives]]\naxis = 'column'\nnode = 1\nrated_current = " +
                   current + "\n" + drive("arm", 2) + drive("belt", 3));
  };
  EXPECT_EQ(with("7.5"), "");
  EXPECT_EQ(with("7500"),
            "crane_drives.toml:6: drives[0].rated_current: 7500 A does not fit current_max 15 A of the axis, "
            "expected a number from 0.46875 to 1500 (A, not mA)");
  EXPECT_EQ(with("0.1"),
            "crane_drives.toml:6: drives[0].rated_current: 0.1 A does not fit current_max 15 A of the axis, "
            "expected a number from 0.46875 to 1500 (A, not mA)");
  EXPECT_EQ(with("0"),
            "crane_drives.toml:6: drives[0].rated_current: 0 is out of range, expected a number from 0.001 to 10000");
}

TEST_F(DriveTableTest, RefusesAxesOfADriveThatItCannotHave) {
  const std::string head = "eds = 'cia402.eds'\nmode = 'position'\n", second = "channel = 2\n";
  std::filesystem::copy_file(scratch_.path() / "drive.eds", scratch_.path() / "cia402.eds");
  const auto with = [&](const std::string& arm, const std::string& belt = drive("belt", 5)) {
    return message(head + drive("column", 1) + arm + belt);
  };
  EXPECT_EQ(with(drive("arm", 1, second)), "");
  EXPECT_EQ(message("eds = 'drive.eds'\nmode = 'position'\n" + drive("column", 1) + drive("arm", 1, second) +
                    drive("belt", 3)),
            "crane_drives.toml:11: drives[1].channel: needs object 6840h:0, which the EDS file does not have, expected "
            "an axis of these drives");
  EXPECT_EQ(with(drive("arm", 1, "channel = 9\n")),
            "crane_drives.toml:11: drives[1].channel: 9 is out of range, expected an integer from 1 to 8");
  EXPECT_EQ(
      with(drive("arm", 1, "channel = 1\n")),
      "crane_drives.toml:11: drives[1].channel: 1 of node 1 is the drive of 'column', expected another axis of the "
      "drive");
  EXPECT_EQ(with(drive("arm", 1, second + "first_pdo = 2\n")),
            "crane_drives.toml:12: drives[1].first_pdo: 2, but two PDOs from 1 on are those of the axis 'column', "
            "expected two PDOs for each axis");
  EXPECT_EQ(with(drive("arm", 1, second), drive("belt", 2)),
            "crane_drives.toml:14: drives[2].node: 2 is the node of the drive of 'arm', expected a unique node");
  EXPECT_EQ(with(drive("arm", 1, second + "pdo_node = 5\n")),
            "crane_drives.toml:15: drives[2].node: 5 is the node of the drive of 'arm', expected a unique node");
  EXPECT_EQ(
      with(drive("arm", 1, second + "pdo_node = 127\n")),
      "crane_drives.toml:12: drives[1].pdo_node: 127 is the master's, expected another one, or another 'master' of "
      "the table");
  EXPECT_EQ(message("eds = 'cia402.eds'\nmode = 'position'\nmaster = 1\n" + drive("column", 127) +
                    drive("arm", 127, second) + drive("belt", 3)),
            "crane_drives.toml:8: drives[1].pdo_node: missing, and 128, node + channel - 1, is no node's number, "
            "expected a number that no node has");
  EXPECT_EQ(with(drive("arm", 1, second + "[drives.objects]\n'0x1840:1' = 7\n")),
            "crane_drives.toml:13: drives[1].objects.'0x1840:1': is of a PDO that the EDP sets up itself, expected an "
            "object that it leaves alone");
}

TEST_F(DriveTableTest, RefusesNodesInUse) {
  const std::string head = "eds = 'drive.eds'\nmode = 'position'\n";
  EXPECT_EQ(message(head + drive("column", 1) + drive("arm", 2) + drive("belt", 1)),
            "crane_drives.toml:13: drives[2].node: 1 is the node of the drive of 'column', expected a unique node, "
            "or a 'channel' for each axis of a drive");
  EXPECT_EQ(message(head + drive("column", 1) + drive("arm", 2) + drive("belt", 127)),
            "crane_drives.toml:13: drives[2].node: 127 is the master's, expected another one, or another 'master' of "
            "the table");
  EXPECT_EQ(message("master = 2\n" + head + drive("column", 1) + drive("arm", 2) + drive("belt", 3)),
            "crane_drives.toml:10: drives[1].node: 2 is the master's, expected another one, or another 'master' of the "
            "table");
  EXPECT_EQ(message(head + drive("column", 128) + drive("arm", 2) + drive("belt", 3)),
            "crane_drives.toml:5: drives[0].node: 128 is out of range, expected an integer from 1 to 127");
  EXPECT_EQ(message(head + drive("column", 0) + drive("arm", 2) + drive("belt", 3)),
            "crane_drives.toml:5: drives[0].node: 0 is out of range, expected an integer from 1 to 127");
}

TEST_F(DriveTableTest, RefusesOtherThanOneDrivePerAxis) {
  const std::string head = "eds = 'drive.eds'\nmode = 'position'\n";
  EXPECT_EQ(message(head + drive("column", 1) + drive("arm", 2)),
            "crane_drives.toml:3: drives: no drive of axis 'belt', expected one for each axis");
  EXPECT_EQ(message(table() + drive("arm", 4)),
            "crane_drives.toml:16: drives[3].axis: 'arm' has an earlier drive, expected one drive for each axis");
  EXPECT_EQ(message(head + drive("colum", 1)),
            "crane_drives.toml:4: drives[0].axis: unknown value 'colum', expected 'column', 'arm' or 'belt'");
}

TEST_F(DriveTableTest, RefusesUnsuitableEdsFiles) {
  EXPECT_EQ(
      message(table().replace(7, 9, "other.eds")),
      "crane_drives.toml:1: eds: 'other.eds' is not there, expected an EDS file beside this one, or 'cia402.eds'");
  EXPECT_EQ(message(table().replace(7, 9, ".")),
            "crane_drives.toml:1: eds: '.' is a directory, expected an EDS file of CiA 306");
  leave_out("60FD");
  EXPECT_EQ(message(table()),
            "crane_drives.toml:1: eds: has no object 60FDh:0, expected a drive for mode 'position', which needs it in "
            "its PDOs");
  leave_out("6071");
  EXPECT_EQ(message(table()), "");  // no target of this mode
  EXPECT_EQ(message(table("", "", "torque")),
            "crane_drives.toml:1: eds: has no object 6071h:0, expected a drive for mode 'torque', which needs it in "
            "its PDOs");
  scratch_.write("drive.eds", "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\n");
  EXPECT_EQ(message(table()),
            "crane_drives.toml:1: eds: has no object 6040h:0, expected a drive for mode 'position', which needs it in "
            "its PDOs");
}

TEST_F(DriveTableTest, RefusesInvalidSettings) {
  const auto with = [&](const std::string& setting) { return message(table("[objects]\n" + setting + "\n")); };
  EXPECT_EQ(
      with("'Maxi torque' = 1"),
      "crane_drives.toml:4: objects.'Maxi torque': 'Maxi torque' is not an object of the EDS file, expected a name "
      "of it or an address like 0x6040 or 0x1018:1");
  EXPECT_EQ(
      with("'torque' = 1"),
      "crane_drives.toml:4: objects.torque: 'torque' is not an object of the EDS file, expected a name of it (Max "
      "torque, "
      "Motor rated torque, Target torque, Torque actual value, Torque offset) or an address like 0x6040 or 0x1018:1");
  EXPECT_EQ(
      with("'0x5fff' = 1"),
      "crane_drives.toml:4: objects.0x5fff: object 5FFFh:0 is not in the EDS file, expected an object of the node");
  EXPECT_EQ(with("'Statusword' = 1"),
            "crane_drives.toml:4: objects.Statusword: may only be read, expected an object that may be written");
  EXPECT_EQ(with("'Max torque' = 70000"),
            "crane_drives.toml:4: objects.'Max torque': 70000 is out of range, expected an integer from 0 to 65535");
  EXPECT_EQ(with("'Max torque' = 1.5"),
            "crane_drives.toml:4: objects.'Max torque': 1.5 is a number, expected an integer from 0 to 65535");
  EXPECT_EQ(with("'Max torque' = 1500\n'0x6072' = 1500"),
            "crane_drives.toml:5: objects.0x6072: is the object of 'Max torque', expected each object once");
  EXPECT_EQ(with("'Home offset' = 2147483648"),
            "crane_drives.toml:4: objects.'Home offset': is written by the EDP itself, as 0, and adds "
            "motor_synchro of the robot's axis, expected an object that it leaves alone");
}

TEST_F(DriveTableTest, RefusesSettingsThatTheEdpWrites) {
  const auto with = [&](const std::string& object) { return message(table("[objects]\n'" + object + "' = 1\n")); };
  EXPECT_EQ(with("Modes of operation"),
            "crane_drives.toml:4: objects.'Modes of operation': is written by the EDP itself, from the key 'mode', "
            "expected an object that it leaves alone");
  EXPECT_EQ(with("0x1017"),
            "crane_drives.toml:4: objects.0x1017: is written by the EDP itself, from the key 'heartbeat', expected an "
            "object that it leaves alone");
  EXPECT_EQ(with("0x1016:1"),
            "crane_drives.toml:4: objects.'0x1016:1': is written by the EDP itself, from the keys 'heartbeat' and "
            "'master', expected an object that it leaves alone");
  EXPECT_EQ(with("0x1016:2"), "");
  EXPECT_EQ(with("0x60c2:1"),
            "crane_drives.toml:4: objects.'0x60c2:1': is written by the EDP itself, from the deployment's "
            "servo_period, expected an object that it leaves alone");
  EXPECT_EQ(with("Controlword"),
            "crane_drives.toml:4: objects.Controlword: is written by the EDP itself, in every cycle, expected an "
            "object that it leaves alone");
  EXPECT_EQ(with("Home offset"),
            "crane_drives.toml:4: objects.'Home offset': is written by the EDP itself, as 0, and adds "
            "motor_synchro of the robot's axis, expected an object that it leaves alone");
  EXPECT_EQ(message(table("absolute_encoders = true\n[objects]\n'Home offset' = 1\n")), "")
      << "the drive's own setting";
  EXPECT_EQ(with("Homing method"),
            "crane_drives.toml:4: objects.'Homing method': is written by the EDP itself, from the drive's key "
            "'homing_method', expected an object that it leaves alone");
  EXPECT_EQ(with("0x1801:2"),
            "crane_drives.toml:4: objects.'0x1801:2': is of a PDO that the EDP sets up itself, expected an object that "
            "it leaves alone");
  EXPECT_EQ(with("0x1801:3"), "");  // its inhibit time is not
  EXPECT_EQ(with("0x1601:1"), "");
  EXPECT_EQ(with("0x1a00:2"),
            "crane_drives.toml:4: objects.'0x1a00:2': is of a PDO that the EDP sets up itself, expected an object that "
            "it leaves alone");
}

}  // namespace
}  // namespace mrroc::config::drive_table_refusal_test
