#include "config/drives/io_table.hpp"

#include "config/drives/drive_table_fixture.hpp"

namespace mrroc::config::io_table_test {
namespace {

/// I/O nodes beside the drives 1, 2, 3 and the master 127.
class IoTableTest : public DriveTableTest {
 protected:
  IoTableTest() {
    std::filesystem::copy_file(MRROC_SOURCE_DIR "/src/canopen/cia401.eds", scratch_.path() / "io.eds");
    drives_ = DriveTableTest::read(table());
  }
  static std::string node(int number, const std::string& more) {
    return "[[nodes]]\nnode = " + std::to_string(number) + "\neds = 'io.eds'\n" + more;
  }
  IoTable read_io(const std::string& text) const { return read_io_table(scratch_.write("io.toml", text), drives_); }
  std::string io_message(const std::string& text) const {
    return replace_folder(message_of(scratch_.path(), [&] { read_io(text); }));
  }

  DriveTable drives_;
};

TEST_F(IoTableTest, TerminalsAreNumberedInTheOrderOfTheFile) {
  const IoTable io = read_io(node(40, "digital_inputs = 10\nanalog_inputs = 3\nanalog_input_range = 20\n") +
                             node(5, "digital_inputs = 6\ndigital_outputs = 16\nanalog_outputs = 8\n"));
  ASSERT_EQ(io.nodes.size(), 2u);
  EXPECT_EQ(io.nodes[0].node, 40);
  EXPECT_EQ(io.nodes[0].digital_inputs.first, 0);
  EXPECT_EQ(io.nodes[1].digital_inputs.first, 10);
  EXPECT_EQ(io.nodes[1].digital_inputs.count, 6);
  EXPECT_EQ(io.nodes[1].digital_outputs.first, 0);
  EXPECT_EQ(io.nodes[0].analog_inputs.range, 20);
  EXPECT_EQ(io.nodes[1].analog_outputs.range, 10);
  EXPECT_EQ(io.digital_inputs(), 16);
  EXPECT_EQ(io_eds_files(scratch_.path() / "io.toml").size(), 2u);
}

TEST_F(IoTableTest, ObjectsAreValuesOfTheNode) {
  const IoTable io = read_io(node(40, "digital_outputs = 8\nobjects = { '0x6207:1' = 0x81 }\n"));
  ASSERT_EQ(io.nodes[0].settings.size(), 1u);
  EXPECT_EQ(io.nodes[0].settings[0].value, 0x81);
  EXPECT_EQ(io.nodes[0].settings[0].size, 1);
}

TEST_F(IoTableTest, RefusesNodesThatAreNotUnique) {
  EXPECT_EQ(io_message(node(2, "digital_inputs = 8\n")),
            "io.toml:2: nodes[0].node: 2 is the node of the drive of 'arm', expected a unique node");
  EXPECT_EQ(io_message(node(127, "digital_inputs = 8\n")),
            "io.toml:2: nodes[0].node: 127 is the master's, expected another one");
  EXPECT_EQ(io_message(node(40, "digital_inputs = 8\n") + node(40, "digital_inputs = 8\n")),
            "io.toml:6: nodes[1].node: 40 is that of an earlier I/O node, expected a unique node");
}

TEST_F(IoTableTest, RefusesMoreTerminalsThanARobotHas) {
  EXPECT_EQ(io_message(node(40, "digital_inputs = 17\n")),
            "io.toml:4: nodes[0].digital_inputs: 17 is out of range, expected an integer from 0 to 16");
  EXPECT_EQ(io_message(node(40, "digital_inputs = 10\n") + node(41, "digital_inputs = 8\n")),
            "io.toml:8: nodes[1].digital_inputs: 8, 18 with those of the nodes before, expected at most 16 of a robot");
  EXPECT_EQ(io_message(node(40, "analog_outputs = 5\n") + node(41, "analog_outputs = 4\n")),
            "io.toml:8: nodes[1].analog_outputs: 4, 9 with those of the nodes before, expected at most 8 of a robot");
}

TEST_F(IoTableTest, RefusesIncompleteTables) {
  EXPECT_EQ(io_message(""), "io.toml:1: nodes: no I/O node, expected [[nodes]], one or more");
  EXPECT_EQ(io_message("[[nodes]]\neds = 'io.eds'\ndigital_outputs = 8\n"),
            "io.toml:1: nodes[0].node: missing, expected an integer from 1 to 127");
  EXPECT_EQ(io_message("[[nodes]]\nnode = 40\ndigital_outputs = 8\n"),
            "io.toml:1: nodes[0].eds: missing, expected a text");
  EXPECT_EQ(io_message(node(40, "")),
            "io.toml:1: nodes[0]: node 40 has no terminals, expected 'digital_inputs', "
            "'digital_outputs', 'analog_inputs' or 'analog_outputs'");
  EXPECT_EQ(io_message(node(40, "digital_input = 8\n")),
            "io.toml:4: nodes[0].digital_input: unknown key, did you mean 'digital_inputs'?");
  EXPECT_EQ(io_message(node(40, "digital_inputs = 8\nanalog_input_range = 10\n")),
            "io.toml:5: nodes[0].analog_input_range: the node has no analog_inputs, expected no such key");
  EXPECT_EQ(io_message("[[nodes]]\nnode = 40\neds = 'other.eds'\ndigital_inputs = 8\n"),
            "io.toml:3: nodes[0].eds: 'other.eds' is not there, expected an EDS file beside this one, or 'cia401.eds'");
  EXPECT_EQ(io_message("[[nodes]]\nnode = 40\neds = 'drive.eds'\ndigital_inputs = 8\n"),
            "io.toml:3: nodes[0].eds: has no object 6000h:1, expected a node with as many terminals as "
            "'digital_inputs'");
}

TEST_F(IoTableTest, RefusesObjectsThatTheEdpWrites) {
  const auto refusal = [this](const std::string& object) {
    return io_message(node(40, "digital_outputs = 8\nobjects = { '" + object + "' = 1 }\n"));
  };
  const std::string start = "io.toml:5: nodes[0].objects.";
  EXPECT_EQ(refusal("0x1401:1"),
            start + "'0x1401:1': is of a PDO that the EDP sets up itself, expected an object that it leaves alone");
  EXPECT_EQ(refusal("0x1017"), start +
                                   "0x1017: is written by the EDP itself, from the heartbeat of the table of drives, "
                                   "expected an object that it leaves alone");
  EXPECT_EQ(refusal("0x6200:1"), start +
                                     "'0x6200:1': is written by the EDP itself, with the robot's outputs, expected an "
                                     "object that it leaves alone");
  EXPECT_EQ(refusal("0x6000:1"), start + "'0x6000:1': may only be read, expected an object that may be written");
}

}  // namespace
}  // namespace mrroc::config::io_table_test
