// The task pick as a user runs it: an arm, the gripper that it carries, an MP that moves both.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sim/state_file.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc {
namespace {

TEST(Pick, TheCubeEndsOnItsMark) {
  const test::ScratchFolder folder;
  test::run_mrroc({"run", "tasks/pick/pick.toml", "--quiet", "--snapshots", folder.path().string()}, 0);
  std::vector<std::filesystem::path> states;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) states.push_back(entry.path());
  ASSERT_FALSE(states.empty());
  const sim::WorldState end = sim::load_state(*std::max_element(states.begin(), states.end()));
  // the scene's bodies come before the robots': position, then quaternion of the cube
  EXPECT_NEAR(end.positions[0], 0.72, 0.002);
  EXPECT_NEAR(end.positions[1], -0.15, 0.005) << "it was gripped 3 mm off the middle of the pads' width";
  EXPECT_NEAR(end.positions[2], 0.5185, 0.001) << "it lies on the table";
  EXPECT_NEAR(std::abs(end.positions[3]), 1, 1e-4) << "it is not turned";
}

TEST(Pick, TwoRunsAreTheSameBitForBit) {
  const test::ScratchFolder folder;
  std::vector<std::string> hashes;
  for (const char* name : {"first.trace", "second.trace"}) {
    const auto trace = folder.path() / name;
    test::run_mrroc({"run", "tasks/pick/pick.toml", "--quiet", "--trace", trace.string()}, 0);
    hashes.push_back(test::trace_hash(trace));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace mrroc
