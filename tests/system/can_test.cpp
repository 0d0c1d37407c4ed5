// `mrroc run` with a robot on a CAN bus: its EDP communicates with its drives only through frames. The bus is a hub of
// Unix sockets, or the interface of the kernel that MRROC_TEST_BUS names.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include "can/bus.hpp"
#include "system/block_scene.hpp"
#include "system/equal_runs_on_a_bus.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::can_test {
namespace {

namespace fs = std::filesystem;
const fs::path kSource = MRROC_SOURCE_DIR;

/// `deployment` with its arm's drives on a bus in `folder`.
std::string on_bus(std::string deployment, const ScratchFolder& folder, const std::string& more = "") {
  const char* const bus = std::getenv("MRROC_TEST_BUS");
  const std::string hardware = "hardware = \"mujoco\"";
  const std::size_t place = deployment.find(hardware);
  if (place != std::string::npos) deployment.replace(place, hardware.size(), "hardware = \"socketcan\"");
  deployment += "\n[robots.arm.can]\nsimulated = true\ninterface = \"";
  deployment += bus != nullptr ? bus : "unix:" + (folder.path() / "bus").string();
  return deployment + "\"\n" + more;
}

std::string press(const ScratchFolder& folder, const std::string& more = "") {
  std::string text = text_of(kSource / "tasks/press/press.toml");
  const std::string scene = "scene = \"";
  text.insert(text.find(scene) + scene.size(), (kSource / "tasks/press").string() + "/");
  return on_bus(text, folder, more);
}

/// Deployment of one arm whose task is `program`.
std::string arm(const std::string& program, const std::string& scene, const std::string& more = "") {
  return "[deployment]\nname = \"can\"\nclock = \"lockstep\"\n\n[robots.arm]\ntype = \"irb6\"\nprogram = "
         "\"" MRROC_BINARY_DIR "/tests/" +
         program + "\"\nhardware = \"mujoco\"\nposition = [0.0, 0.0, 0.7]\n" + more + "\n[sim]\nscene = \"" + scene +
         "\"\n";
}

/// `key = value` lines that replace those of the type's own table of drives.
fs::path drives(const ScratchFolder& folder, const std::string& mode, const std::string& per_drive) {
  std::string text = text_of(kSource / "robots/irb6/irb6_drives.toml");
  const std::string position = "mode = \"position\"";
  text.replace(text.find(position), position.size(), "mode = \"" + mode + "\"");
  const std::string current = "rated_current";
  for (std::size_t at = text.find(current); at != std::string::npos; at = text.find(current, at + 1)) {
    text.insert(at, per_drive);
    at += per_drive.size();
  }
  return folder.write("drives.toml", text);
}

TEST(Can, PressReachesTheSameEndOverABus) {
  const ScratchFolder folder;
  expect_equal_runs_on_a_bus(folder.write("press.toml", press(folder)), folder, {"press succeeded: 9.342 s"});
}

TEST(Can, PressSucceedsInEveryModeOfTheDrives) {
  for (const auto& [mode, per_drive] : {std::pair{"velocity", "position_gain = 50.0\n"}, {"torque", ""}}) {
    const ScratchFolder folder;
    const auto table = drives(folder, mode, per_drive);
    const auto file = folder.write("press.toml", press(folder, "drives = \"" + table.string() + "\"\n"));
    const std::string output = run_mrroc({"run", file.string()}, 0);
    EXPECT_NE(output.find("press succeeded"), std::string::npos) << mode << "\n" << output;
  }
}

/// A machine without a real-time kernel may delay drives or servo by three ticks at any time. The robot then stops, and
/// the error names the drive, or the bus when no drive is in time, and the reason.
void expect_late_drive(const MrrocRun& run) {
  const std::size_t place = run.err().find("press: hardware error: ");
  ASSERT_NE(place, std::string::npos) << run.out() << run.err();
  const std::string line = run.err().substr(place, run.err().find('\n', place) - place);
  EXPECT_TRUE(line.find("the hardware does not answer: axis ") != std::string::npos ||
              line.find("no drive has answered") != std::string::npos ||
              line.find("a joint is faster than its limit: axis ") != std::string::npos)
      << line;
}

void expect_nothing_left(const MrrocRun& run) {
  EXPECT_EQ((run.out() + run.err()).find("not every robot has stopped"), std::string::npos) << run.out() << run.err();
  EXPECT_TRUE(all_end(run.descendants()));
}

TEST(Can, PressSucceedsUnderTheRealClockOrNamesTheLateDrive) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  MrrocRun run({"run", file.string(), "--clock", "real"});
  if (run.wait() == 0)
    EXPECT_NE(run.out().find("press succeeded"), std::string::npos) << run.out();
  else
    expect_late_drive(run);
  expect_nothing_left(run);
}

TEST(Can, AnArmThatMeetsABlockStopsRecoversAndGoesHome) {
  const ScratchFolder folder;
  folder.write("block.xml", kBlockScene);
  const auto file = folder.write("recover.toml", on_bus(arm("recover_ecp", "block.xml"), folder));
  const std::string output = run_mrroc({"run", file.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("stopped: hardware error: "), std::string::npos) << output;
  EXPECT_NE(output.find("| recovered"), std::string::npos) << output;
}

void expect_killed_edp(const MrrocRun& run) {
  EXPECT_NE((run.out() + run.err()).find("process arm_edp died"), std::string::npos) << run.out() << run.err();
}

TEST(Can, KilledEdpLeavesNoDriveRunning) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  MrrocRun run({"run", file.string(), "--inject", "kill edp:arm at tick 1500"});
  EXPECT_EQ(run.wait(), 4) << run.out() << run.err();
  expect_killed_edp(run);
  expect_nothing_left(run);
}

TEST(Can, KilledEdpLeavesNoDriveRunningUnderTheRealClock) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  // the drives have power at that tick
  MrrocRun run({"run", file.string(), "--clock", "real", "--inject", "kill edp:arm at tick 150"});
  if (run.wait() == 4)
    expect_killed_edp(run);
  else
    expect_late_drive(run);
  expect_nothing_left(run);
}

TEST(Can, KilledDrivesStopTheRun) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  MrrocRun run({"run", file.string(), "--inject", "kill drives:arm at tick 1500"});
  EXPECT_EQ(run.wait(), 4) << run.out() << run.err();
  EXPECT_NE((run.out() + run.err()).find("arm_drives"), std::string::npos) << run.out() << run.err();
}

TEST(Can, SameDeploymentRunsAgainAfterKilledDrives) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  run_mrroc({"run", file.string(), "--inject", "kill drives:arm at tick 1500"}, 4);
  const std::string output = run_mrroc({"run", file.string()}, 0);
  EXPECT_NE(output.find("press succeeded"), std::string::npos) << output;
}

/// A temporary fault of one drive, and the text of its error.
struct DriveFault {
  const char* action;
  const char* error;  ///< empty: one or another
};

class DriveFaults : public testing::TestWithParam<DriveFault> {};

TEST_P(DriveFaults, StopTheArmWhichRecovers) {
  const ScratchFolder folder;
  folder.write("room.xml", "<mujoco><compiler angle=\"radian\"/></mujoco>");
  // otherwise a restarted drive has lost its position, and the arm would need synchronisation
  std::string table = text_of(kSource / "robots/irb6/irb6_drives.toml");
  const std::string no = "absolute_encoders = false";
  ASSERT_NE(table.find(no), std::string::npos);
  table.replace(table.find(no), no.size(), "absolute_encoders = true");
  const std::string more = "drives = \"" + folder.write("drives.toml", table).string() + "\"\n";
  const auto file = folder.write("fault.toml", on_bus(arm("bus_fault_ecp", "room.xml"), folder, more));
  const std::string fault = GetParam().action + std::string{" drives:arm axis 2 at tick 1000 for 600 ticks"};
  const std::string output = run_mrroc({"run", file.string(), "--inject", fault}, 0);
  const std::size_t stopped = output.find("stopped: hardware error: ");
  ASSERT_NE(stopped, std::string::npos) << output;
  const std::string line = output.substr(stopped, output.find('\n', stopped) - stopped);
  EXPECT_NE(line.find(GetParam().error), std::string::npos) << line;
  EXPECT_NE(line.find("lower_arm"), std::string::npos) << line;
  EXPECT_NE(output.find("| recovered"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Can, DriveFaults,
                         testing::Values(DriveFault{"fault", "7305h"}, DriveFault{"silence", "does not answer"},
                                         DriveFault{"freeze", "does not move"}, DriveFault{"restart", "restarted"},
                                         DriveFault{"hush", "heartbeat"}, DriveFault{"corrupt", ""}),
                         [](const auto& each) { return std::string{each.param.action}; });

TEST(Can, PressedLimitSwitchStopsTheArm) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  MrrocRun run({"run", file.string(), "--inject", "press drives:arm axis 2 at tick 1500"});
  EXPECT_EQ(run.wait(), 3) << run.out() << run.err();
  EXPECT_NE(run.err().find("a limit switch stops the axis: axis 2 (lower_arm), tick 150"), std::string::npos)
      << run.err();
}

/// Another node on the bus, which sends positions with the number of the arm's second drive until it ends, as many as a
/// bus of 1 Mbit/s carries.
class Impostor {
 public:
  explicit Impostor(const std::string& interface) : bus_(can::open_bus(interface)) {
    thread_ = std::thread([this] {
      std::mt19937 random(1);
      while (!done_) {
        can::Frame frame{0x182, {0, 0, 0, 0, 0, 0, 0, 0}};
        for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random());
        bus_->send(frame);
        std::this_thread::sleep_for(std::chrono::microseconds(125));
      }
    });
  }
  ~Impostor() {
    done_ = true;
    thread_.join();
  }
  Impostor(const Impostor&) = delete;
  Impostor& operator=(const Impostor&) = delete;

 private:
  std::unique_ptr<can::Bus> bus_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

TEST(Can, NodeWithADrivesNumberIsDetectedAndTheArmRecoversWithoutIt) {
  const ScratchFolder folder;
  folder.write("room.xml", "<mujoco><compiler angle=\"radian\"/></mujoco>");
  const std::string text = on_bus(arm("bus_fault_ecp", "room.xml"), folder);
  const std::string key = "interface = \"";
  const std::size_t begin = text.find(key) + key.size();
  MrrocRun run({"run", folder.write("fault.toml", text).string()});
  ASSERT_TRUE(run.wait_for_output("arm          running")) << run.out() << run.err();
  {
    const Impostor impostor(text.substr(begin, text.find('"', begin) - begin));
    EXPECT_TRUE(run.wait_for_output("stopped: hardware error: ")) << run.out() << run.err();
  }
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
  const std::size_t stopped = run.out().find("stopped: hardware error: ");
  ASSERT_NE(stopped, std::string::npos) << run.out();
  const std::string line = run.out().substr(stopped, run.out().find('\n', stopped) - stopped);
  EXPECT_NE(line.find("axis 2 (lower_arm)"), std::string::npos) << line;
  EXPECT_NE(run.out().find("| recovered"), std::string::npos) << run.out();
  expect_nothing_left(run);
}

TEST(Can, RefusesAFaultOfAnUnknownDrive) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press(folder));
  MrrocRun run({"run", file.string(), "--inject", "hush drives:arm axis 7 at tick 1000"});
  EXPECT_EQ(run.wait(), 1) << run.out() << run.err();
  EXPECT_NE((run.out() + run.err()).find("axis 7 at tick 1000\": irb6 has 6 axes"), std::string::npos)
      << run.out() << run.err();
}

TEST(Can, RealDrivesNeedTheRealClock) {
  const ScratchFolder folder;
  std::string text = press(folder);
  const std::string simulated = "simulated = true\n";
  text.erase(text.find(simulated), simulated.size());
  const auto file = folder.write("press.toml", text);
  MrrocRun run({"run", file.string()});
  EXPECT_EQ(run.wait(), 2);
  EXPECT_NE(run.err().find("robots.arm.can"), std::string::npos) << run.err();
  EXPECT_NE(run.err().find("clock = 'real'"), std::string::npos) << run.err();
}

}  // namespace
}  // namespace mrroc::test::can_test
