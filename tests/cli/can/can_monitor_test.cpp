#include "cli/can/can_monitor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numbers>

#include "can/hub.hpp"
#include "canopen/random_frames.hpp"
#include "cli/can/can_nodes.hpp"
#include "cli/can/can_summary.hpp"
#include "cli/processes/child.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::can_monitor_test {
namespace {

using namespace canopen;
using can::Frame;

/// A PDO with these values of the mapping's objects.
Frame pdo(std::uint32_t id, const PdoMapping& mapping, const std::vector<std::int64_t>& values) {
  Frame frame{id, {}};
  for (std::size_t i = 0; i < values.size(); ++i) mapping.write(frame, mapping.objects()[i].object, values[i]);
  return frame;
}

/// Frames of one cycle of the IRb-6's first drive, which has 4000 units per revolution.
struct Cycle {
  config::DriveTable table = irb6_drives();
  edp::DrivePdos pdos = edp::drive_pdos(table.mode);
  std::int64_t turn = std::llround(table.drives[0].units_per_turn);
  Frame command = pdo(0x201, pdos.command, {kEnableOperation, turn / 4, 8});
  Frame feedback = pdo(0x181, pdos.feedback, {0x1637, -turn, 250});
  Frame status = pdo(0x281, pdos.status, {turn, kPositiveLimitSwitch});
};

TEST(CanFrameFormatter, NameDrivesByTheirAxes) {
  Cycle cycle;
  CanFrameFormatter words(cycle.table);
  EXPECT_EQ(words.line(cycle.command), "column RPDO 1: enable operation; cyclic synchronous position, 1.57080 rad");
  EXPECT_EQ(words.line(cycle.feedback),
            "column TPDO 1: operation enabled, target reached, follows command; -6.28319 rad, 2.500 A");
  EXPECT_EQ(words.line(cycle.status), "column TPDO 2: 6.2832 rad/s; positive limit switch");
  EXPECT_EQ(words.line(heartbeat_frame(2, NmtState::operational)), "lower_arm heartbeat: operational");
  EXPECT_EQ(words.line(heartbeat_frame(127, NmtState::operational)), "master heartbeat: operational");
  EXPECT_EQ(words.line(heartbeat_frame(12, NmtState::operational)), "node 12 heartbeat: operational");
  EXPECT_EQ(words.line(nmt_frame(NmtCommand::start, 1)), "NMT column: start");
  EXPECT_EQ(words.line(nmt_frame(NmtCommand::start, 12)), "NMT node 12: start");
  EXPECT_EQ(words.line(nmt_frame(NmtCommand::start, 0)), "NMT all nodes: start");
  EXPECT_EQ(words.line(Frame{0x081, {0x05, 0x73, 0x20, 0, 0, 0, 0, 0}}),
            "column emergency 7305h: incremental sensor 1 fault, register 20, maker's 00 00 00 00 00");
  EXPECT_EQ(words.line(Frame{0x601, {0x2f, 0x60, 0x60, 0, 8, 0, 0, 0}}),
            "column SDO write 6060h:0 (Modes of operation) = 08");
  EXPECT_EQ(words.line(Frame{0x181, {1, 2}}), "column TPDO 1: 01 02") << "too short";
  EXPECT_EQ(words.line(sync_frame()), "SYNC");
}

TEST(CanFrameFormatter, ReadAStatuswordInTheCommandedMode) {
  Cycle cycle;
  CanFrameFormatter words(cycle.table);
  words.line(pdo(0x201, cycle.pdos.command, {kEnableOperation | kStartHoming, 0, 6}));
  EXPECT_EQ(words.line(pdo(0x181, cycle.pdos.feedback, {0x1637, 0, 0})),
            "column TPDO 1: operation enabled, target reached, homing attained; 0.00000 rad, 0.000 A");
}

TEST(CanFrameFormatter, DriveWithReversedCounter) {
  Cycle cycle;
  cycle.table.drives[0].units_per_turn *= -1;
  CanFrameFormatter words(cycle.table);
  EXPECT_EQ(words.line(cycle.feedback),
            "column TPDO 1: operation enabled, target reached, follows command; 6.28319 rad, -2.500 A");
}

TEST(CanFrameFormatter, DriveThatReportsRevolutionsPerMinute) {
  Cycle cycle;
  cycle.table.drives[0].velocity_units_per_turn = 60;
  cycle.table.mode = DriveMode::cyclic_velocity;
  CanFrameFormatter words(cycle.table);
  EXPECT_EQ(words.line(pdo(0x281, cycle.pdos.status, {30, 0})), "column TPDO 2: 3.1416 rad/s; no switch");
  const auto velocity = edp::drive_pdos(cycle.table.mode).command;
  EXPECT_EQ(words.line(pdo(0x201, velocity, {kEnableOperation, 90, 9})),
            "column RPDO 1: enable operation; cyclic synchronous velocity, 9.4248 rad/s");
}

TEST(CanFrameFormatter, OtherModes) {
  Cycle cycle;
  cycle.table.mode = DriveMode::cyclic_torque;
  const auto torque = edp::drive_pdos(cycle.table.mode).command;
  EXPECT_EQ(CanFrameFormatter(cycle.table).line(pdo(0x201, torque, {kEnableOperation, -500, 10})),
            "column RPDO 1: enable operation; cyclic synchronous torque, -5.000 A");
  cycle.table.mode = DriveMode::cyclic_velocity;
  const auto velocity = edp::drive_pdos(cycle.table.mode).command;
  EXPECT_EQ(CanFrameFormatter(cycle.table).line(pdo(0x201, velocity, {kEnableOperation, cycle.turn, 9})),
            "column RPDO 1: enable operation; cyclic synchronous velocity, 6.2832 rad/s");
}

TEST(CanFrameFormatter, NetworkTextWithoutATable) {
  EXPECT_EQ(CanFrameFormatter().line(Frame{0x181, {0x37, 0x16}}), "node 1 TPDO 1: 37 16");
}

TEST(CanFrameFormatter, OnePrintableLineForAnyFrame) {
  CanFrameFormatter words(irb6_drives());
  EXPECT_TRUE(rc::check("any frame", [&words](Frame frame) {
    if (*rc::gen::arbitrary<bool>()) frame.id = (frame.id & 0x780) | *rc::gen::inRange<std::uint32_t>(1, 7);
    const std::string text = words.line(frame);
    RC_ASSERT(!text.empty());
    RC_ASSERT(std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 0x20 && letter < 0x7f; }));
  }));
}

TEST(CanSummary, CountsFramesAndTheirLoad) {
  EXPECT_EQ(bits_on_the_wire(0), 55u);
  EXPECT_EQ(bits_on_the_wire(8), 135u);
  const Cycle cycle;
  CanSummary summary;
  for (int i = 0; i < 500; ++i) {
    summary.add(sync_frame());
    summary.add(cycle.feedback);
  }
  Frame error;
  error.error = true;
  summary.add(error);
  EXPECT_EQ(summary.text(CanFrameFormatter(cycle.table), 1.0, 1e6),
            "id    what                             frames      per s   load %\n"
            "080h  SYNC                                500      500.0     2.75\n"
            "181h  column TPDO 1                       500      500.0     6.75\n"
            "all   in 1.000 s                         1000     1000.0     9.50\n"
            "1 errors that the controller has reported\n");
}

class CanMonitor : public testing::Test {
 protected:
  task_test::ScratchFolder folder_;
  std::unique_ptr<can::Hub> hub_ = std::make_unique<can::Hub>(folder_ / "bus");
  std::unique_ptr<can::Bus> sender_ = can::open_bus(hub_->name());

  std::string program(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"can", "monitor", hub_->name()});
    Child child("mrroc", std::string(MRROC_BINARY_DIR) + "/bin/mrroc", arguments);
    while (!child.ended()) {  // the monitor may not receive yet
      sender_->send(Cycle().feedback);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const std::string output = child.wait_for_output();
    EXPECT_EQ(child.exit_code(), 0) << output;
    return output;
  }
};

TEST_F(CanMonitor, EndsWithItsBus) {
  const auto bus = can::open_bus(hub_->name());
  sender_->send(sync_frame());
  hub_.reset();
  CanFrameFormatter words;
  const auto stop = [] { return false; };
  EXPECT_THROW(monitor(*bus, words, {}, stop, [](std::string_view) {}), std::runtime_error);
}

TEST_F(CanMonitor, EndsOnRequest) {
  const auto bus = can::open_bus(hub_->name());
  CanFrameFormatter words;
  const auto stop = [] { return true; };
  monitor(*bus, words, {}, stop, [](std::string_view text) { FAIL() << text; });
}

TEST_F(CanMonitor, TheProgramPrintsALineForEachFrame) {
  const std::string output = program({"--robot", "irb6", "--count", "3"});
  const std::string words =
      "  column TPDO 1: operation enabled, target reached, follows command; -6.28319 rad, 2.500 A\n";
  EXPECT_TRUE(output.starts_with("    0.000000" + words)) << output;
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 3);
  EXPECT_TRUE(program({"--count", "1"}).starts_with("    0.000000  node 1 TPDO 1: 37 16 ")) << "without a table";
}

TEST_F(CanMonitor, TheProgramPrintsASummary) {
  const std::string output = program({"--summary", "--count", "4", "--seconds", "60"});
  EXPECT_TRUE(
      output.starts_with("id    what                             frames      per s   load %\n"
                         "181h  node 1 TPDO 1                         4  "))
      << output;
}

TEST_F(CanMonitor, TheProgramEndsWithASignal) {
  Child child("mrroc", std::string(MRROC_BINARY_DIR) + "/bin/mrroc", {"can", "monitor", hub_->name()});
  while (!child.ended() && child.read_lines().empty()) {
    sender_->send(sync_frame());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  child.signal(SIGINT);
  child.wait_for_output();
  EXPECT_EQ(child.exit_code(), 0);
}

TEST_F(CanMonitor, TheProgramRefusesATableWithoutARobot) {
  Child child("mrroc", std::string(MRROC_BINARY_DIR) + "/bin/mrroc", {"can", "monitor", "can0", "--drives", "x.toml"});
  EXPECT_NE(child.wait_for_output().find("--drives requires --robot"), std::string::npos);
  EXPECT_EQ(child.exit_code(), 2);
}

}  // namespace
}  // namespace mrroc::cli::can_monitor_test
