// Runs over a bus in lockstep are equal however busy the machine is, and however long the drives take.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "replace.hpp"
#include "system/held_threads.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::can_lockstep_test {
namespace {

namespace fs = std::filesystem;
const fs::path kTasks = fs::path(MRROC_SOURCE_DIR) / "tasks";

/// The deployment of `press` over a bus in `folder`.
fs::path press_on_bus(const ScratchFolder& folder) {
  std::string text = text_of(kTasks / "press/press_can.toml");
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"press.xml\"", kTasks / "press/press.xml"},
                                 {"\"can0\"", "unix:" + (folder.path() / "bus").string()}}) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), "\"" + to + "\"");
  }
  return folder.write("press.toml", text);
}

std::string hash_of_run(const fs::path& deployment, const fs::path& trace, int hold = 0) {
  MrrocRun run({"run", deployment.string(), "--record", trace.string()});
  for (int i = 0; i < hold; ++i) {
    EXPECT_TRUE(run.wait_for_output("JointLine")) << run.out() << run.err();
    // the thread of the bus, longer than any cycle may take; the process still sends its heartbeat
    const HeldThreads drives(run.child("arm_drives"), HeldThreads::Which::newest);
    EXPECT_EQ(drives.count(), 1U);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const auto size = fs::file_size(trace);
    std::this_thread::sleep_for(std::chrono::milliseconds(2000));
    EXPECT_EQ(fs::file_size(trace), size) << "the run stands still meanwhile";
  }
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
  return trace_hash(trace);
}

TEST(CanLockstep, RunsAreEqualBesideBusyProcessesAndWithHeldDrives) {
  const ScratchFolder folder;
  const fs::path deployment = press_on_bus(folder);
  const std::string quiet = hash_of_run(deployment, folder.path() / "quiet.mcap");
  {
    const Load load(8);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(hash_of_run(deployment, folder.path() / ("busy" + std::to_string(i) + ".mcap")), quiet);
  }
  EXPECT_EQ(hash_of_run(deployment, folder.path() / "held.mcap", 2), quiet);
}

/// Two drives of three axes in the place of six. Their modes are confirmed one after the other, so the task starts
/// later.
TEST(CanLockstep, DrivesWithSeveralAxesRunAsOneForEachAxis) {
  const ScratchFolder folder;
  const fs::path deployment = press_on_bus(folder);
  std::string drives = text_of(fs::path(MRROC_SOURCE_DIR) / "robots/irb6/irb6_drives.toml");
  for (int axis = 5; axis >= 0; --axis) {
    const std::string node = std::to_string(1 + axis / 3 * 3), channel = std::to_string(1 + axis % 3);
    replace(drives, "node = " + std::to_string(axis + 1) + "\n", "node = " + node + "\nchannel = " + channel + "\n");
  }
  std::string text = text_of(deployment);
  replace(text, "simulated = true",
          "simulated = true\ndrives = '" + folder.write("drives.toml", drives).string() + "'");
  const fs::path several = folder.write("several.toml", text);
  const std::string hash = hash_of_run(several, folder.path() / "first.mcap");
  {
    const Load load(4);
    EXPECT_EQ(hash_of_run(several, folder.path() / "busy.mcap"), hash);
  }
  expect_laws(folder.path() / "first.mcap");
  hash_of_run(deployment, folder.path() / "one.mcap");
  const Steps found = steps_of(folder.path() / "first.mcap"), expected = steps_of(folder.path() / "one.mcap");
  ASSERT_EQ(found.size(), expected.size());
  const Tick later = found.front().tick - expected.front().tick;
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].tick, expected[i].tick + later) << i;
}

}  // namespace
}  // namespace mrroc::test::can_lockstep_test
