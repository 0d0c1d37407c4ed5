#include "cli/can/io_frame_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <thread>

#include "can/hub.hpp"
#include "canopen/emergency.hpp"
#include "canopen/random_frames.hpp"
#include "cli/can/can_frame_formatter.hpp"
#include "cli/can/can_nodes.hpp"
#include "cli/processes/child.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::io_frame_text_test {
namespace {

using namespace canopen;
using can::Frame;

/// Node 40 with 6 inputs; node 41 with 10 inputs, 4 outputs, 5 analogue inputs of 20 mA and 1 analogue output of 10 V.
constexpr const char* kTable = R"(
[[nodes]]
node = 40
eds = "cia401.eds"
digital_inputs = 6

[[nodes]]
node = 41
eds = "cia401.eds"
digital_inputs = 10
digital_outputs = 4
analog_inputs = 5
analog_input_range = 20.0
analog_outputs = 1
)";

class IoFrames : public testing::Test {
 protected:
  task_test::ScratchFolder folder_;
  std::filesystem::path file_ = folder_.write("io.toml", kTable);
  CanFrameFormatter words_ = [this] {
    CanFrameFormatter words(irb6_drives());
    words.add(config::read_io_table(file_, irb6_drives()));
    return words;
  }();
};

TEST_F(IoFrames, HaveTheRobotsNumbersOfTheTerminals) {
  EXPECT_EQ(words_.line(Frame{0x180 + 40, {0b1001}}), "I/O node 40 TPDO 1: digital inputs 0 to 5, on: 0, 3");
  EXPECT_EQ(words_.line(Frame{0x180 + 41, {0b10, 0b10}}), "I/O node 41 TPDO 1: digital inputs 6 to 15, on: 7, 15");
  EXPECT_EQ(words_.line(Frame{0x200 + 41, {0}}), "I/O node 41 RPDO 1: digital outputs 0 to 3, all off");
}

TEST_F(IoFrames, HaveAnalogueValuesInTheUnitOfTheTable) {
  EXPECT_EQ(words_.line(Frame{0x280 + 41, {0xff, 0x7f, 0x01, 0x80, 0, 0, 0, 0}}),
            "I/O node 41 TPDO 2: analogue inputs 0 = 20.000, 1 = -20.000, 2 = 0.000, 3 = 0.000");
  EXPECT_EQ(words_.line(Frame{0x380 + 41, {0, 0x40}}), "I/O node 41 TPDO 3: analogue inputs 4 = 10.000");
  EXPECT_EQ(words_.line(Frame{0x300 + 41, {0, 0xc0}}), "I/O node 41 RPDO 2: analogue outputs 0 = -5.000");
}

TEST_F(IoFrames, NetworkFramesNameTheNode) {
  EXPECT_EQ(words_.line(heartbeat_frame(40, NmtState::boot_up)), "I/O node 40 heartbeat: boot-up");
  EXPECT_EQ(words_.line(nmt_frame(NmtCommand::start, 41)), "NMT I/O node 41: start");
  EXPECT_EQ(
      words_.line(Frame{0x080 + 40, {0x00, 0x50, 1, 0, 0, 0, 0, 0}}),
      "I/O node 40 emergency 5000h: " + std::string(error_text(0x5000)) + ", register 01, maker's 00 00 00 00 00");
  EXPECT_TRUE(
      words_.line(Frame{0x600 + 41, {0x2f, 0x06, 0x62, 1, 8, 0, 0, 0}}).starts_with("I/O node 41 SDO write 6206h:1 ("));
  EXPECT_EQ(words_.kind(0x1a8), "I/O node 40 TPDO 1");
  EXPECT_EQ(words_.line(heartbeat_frame(2, NmtState::operational)), "lower_arm heartbeat: operational");
}

TEST_F(IoFrames, KeepTheirBytesWhenTheyAreShortOrUnused) {
  EXPECT_EQ(words_.line(Frame{0x180 + 41, {2}}), "I/O node 41 TPDO 1: 02") << "too short";
  EXPECT_EQ(words_.line(Frame{0x200 + 40, {2}}), "I/O node 40 RPDO 1: 02") << "it has no outputs";
  EXPECT_EQ(words_.line(Frame{0x480 + 40, {2}}), "I/O node 40 TPDO 4: 02");
}

TEST_F(IoFrames, OnePrintableLineForAnyFrame) {
  EXPECT_TRUE(rc::check("any frame", [this](Frame frame) {
    if (*rc::gen::arbitrary<bool>()) frame.id = (frame.id & 0x780) | *rc::gen::inRange<std::uint32_t>(40, 42);
    const std::string text = words_.line(frame);
    RC_ASSERT(!text.empty());
    RC_ASSERT(std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 0x20 && letter < 0x7f; }));
  }));
}

TEST_F(IoFrames, TheProgramNeedsNoRobot) {
  const can::Hub hub(folder_ / "bus");
  const auto sender = can::open_bus(hub.name());
  Child child("mrroc", std::string(MRROC_BINARY_DIR) + "/bin/mrroc",
              {"can", "monitor", hub.name(), "--io", file_.string(), "--count", "1"});
  while (!child.ended()) {  // the monitor may not receive yet
    sender->send(Frame{0x180 + 40, {0b100}});
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(child.wait_for_output(), "    0.000000  I/O node 40 TPDO 1: digital inputs 0 to 5, on: 2\n");
  EXPECT_EQ(child.exit_code(), 0);
}

TEST_F(IoFrames, TheProgramRefusesANodeWithTheNumberOfADrive) {
  const auto file = folder_.write("wrong.toml", "[[nodes]]\nnode = 3\neds = \"cia401.eds\"\ndigital_inputs = 1\n");
  Child child("mrroc", std::string(MRROC_BINARY_DIR) + "/bin/mrroc",
              {"can", "monitor", "unix:/none", "--robot", "irb6", "--io", file.string()});
  const std::string output = child.wait_for_output();
  EXPECT_NE(output.find("wrong.toml"), std::string::npos) << output;
  EXPECT_NE(output.find("node"), std::string::npos) << output;
  EXPECT_EQ(child.exit_code(), 2) << output;
}

}  // namespace
}  // namespace mrroc::cli::io_frame_text_test
