// Runs with the stand-ins of a UR controller and of a Net F/T in lockstep are equal however busy the machine is, and
// however long the stand-ins take.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "system/held_threads.hpp"
#include "system/mrroc_run.hpp"
#include "system/ur_on_stand_in.hpp"

namespace mrroc::test::ur_lockstep_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr int kSystem = 4;  // exit code

/// What two runs are compared by.
struct Result {
  int exit_code;
  std::string end;  ///< simulated time and outcome
  std::string hash;
  friend bool operator==(const Result&, const Result&) = default;
};

/// Words of the line "press succeeded: 9.344 s in 1.2 s of wall time", without the wall time.
std::string end_of(const std::string& output) {
  const std::size_t end = output.find(" s in ");
  const std::size_t begin = output.rfind('\n', end);
  return end == std::string::npos ? output : output.substr(begin + 1, end - begin - 1);
}

/// Runs the deployment; `held`: twice the newest thread of the controller's stand-in is held for 2 s.
Result run_once(const fs::path& deployment, const ScratchFolder& folder, bool held = false) {
  const fs::path trace = folder.path() / "trace.mcap";
  fs::remove(trace);
  MrrocRun run({"run", deployment.string(), "--record", trace.string()});
  for (int i = 0; held && i < 2; ++i) {
    EXPECT_TRUE(run.wait_for_output("JointLine")) << run.out() << run.err();
    const HeldThreads thread(run.child("arm_drives"), HeldThreads::Which::newest);
    EXPECT_EQ(thread.count(), 1U);
    std::this_thread::sleep_for(500ms);
    const auto size = fs::file_size(trace);
    std::this_thread::sleep_for(2s);
    EXPECT_EQ(fs::file_size(trace), size) << "the run stands still meanwhile";
  }
  const int exit_code = run.wait();
  EXPECT_EQ(exit_code, 0) << run.out() << run.err();
  expect_laws(trace);
  return {exit_code, end_of(run.out()), trace_hash(trace)};
}

class UrLockstep : public testing::TestWithParam<const char*> {
 protected:
  fs::path press() const {
    const std::string source = GetParam();
    return folder_.write("press.toml",
                         press_on_ur_stand_in(folder_, source == "netft" ? netft_stand_in() : "source = \"ur\""));
  }

  const ScratchFolder folder_;
};

TEST_P(UrLockstep, PressIsEqualBesideBusyProcessesAndWithAHeldStandIn) {
  const fs::path deployment = press();
  const Result quiet = run_once(deployment, folder_);
  EXPECT_NE(quiet.end.find("press succeeded"), std::string::npos) << quiet.end;
  EXPECT_EQ(run_once(deployment, folder_), quiet);
  {
    const Load load(8);
    EXPECT_EQ(run_once(deployment, folder_), quiet);
  }
  EXPECT_EQ(run_once(deployment, folder_, true), quiet);
}

TEST_P(UrLockstep, AStandInThatDiesIsNamed) {
  const bool netft = std::string(GetParam()) == "netft";
  const std::string name = netft ? "wrist_netft" : "arm_drives";
  MrrocRun run({"run", press().string()});
  ASSERT_TRUE(run.wait_for_output("JointLine")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  ASSERT_EQ(kill(run.child(name), SIGKILL), 0);
  EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
  EXPECT_NE(run.err().find("process " + name + " died: signal 9 (Killed)"), std::string::npos) << run.err();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Source, UrLockstep, testing::Values("netft", "ur"),
                         [](const auto& test) { return std::string(test.param); });

/// The demo of the arm without sensors.
fs::path demo(const ScratchFolder& folder) {
  std::string text =
      "[deployment]\nname = \"demo\"\nclock = \"lockstep\"\n\n[robots.arm]\ntype = \"irb6\"\n"
      "program = \"irb6_demo\"\nhardware = \"mujoco\"\nposition = [0.0, 0.0, 0.7]\n\n[sim]\nscene = \"";
  text += (fs::path(MRROC_SOURCE_DIR) / "tasks/press/press.xml").string() + "\"\n";
  return folder.write("demo.toml", on_ur_stand_in(text, folder));
}

TEST(UrLockstepMotion, JointMotionIsEqualBesideBusyProcesses) {
  const ScratchFolder folder;
  const fs::path deployment = demo(folder);
  const Result quiet = run_once(deployment, folder);
  const Load load(8);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(run_once(deployment, folder), quiet);
}

TEST(UrLockstepMotion, TwoControllersAreEqualInTwoRuns) {
  const ScratchFolder folder;
  std::string text = "[deployment]\nname = \"two\"\nclock = \"lockstep\"\n[sim]\nscene = \"";
  text += (fs::path(MRROC_SOURCE_DIR) / "tasks/press/press.xml").string() + "\"\n";
  for (const char* const name : {"left", "right"}) {
    const std::string y = name == std::string("left") ? "0.0" : "3.0";
    text += std::string("[robots.") + name + "]\ntype = \"irb6\"\nprogram = \"irb6_demo\"\nposition = [0.0, " + y +
            ", 0.7]\nhardware = \"mujoco\"\n";
    text = on_ur_stand_in(text, folder);
  }
  const fs::path deployment = folder.write("two.toml", text);
  const Result first = run_once(deployment, folder);
  EXPECT_EQ(run_once(deployment, folder), first);
}

}  // namespace
}  // namespace mrroc::test::ur_lockstep_test
