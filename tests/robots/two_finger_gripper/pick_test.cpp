// The task pick as run by a user: an arm, the gripper that it carries, and an MP that moves both.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sim/state_file.hpp"
#include "system/equal_runs.hpp"

namespace mrroc::pick_test {
namespace {

TEST(Pick, CubeEndsOnItsMarkEquallyInTwoRuns) {
  const test::ScratchFolder folder;
  const test::EqualRuns runs = test::expect_equal_runs("tasks/pick/pick.toml", folder);
  std::vector<std::filesystem::path> states;
  for (const auto& entry : std::filesystem::directory_iterator(runs.states)) states.push_back(entry.path());
  ASSERT_FALSE(states.empty());
  const sim::WorldState end = sim::load_state(*std::max_element(states.begin(), states.end()));
  // the scene's bodies precede the robots': position, then quaternion of the cube
  EXPECT_NEAR(end.positions[0], 0.72, 0.002);
  EXPECT_NEAR(end.positions[1], -0.15, 0.005) << "it was gripped 3 mm off the centre of the pads' width";
  EXPECT_NEAR(end.positions[2], 0.5185, 0.001) << "it lies on the table";
  EXPECT_NEAR(std::abs(end.positions[3]), 1, 1e-4) << "it is not turned";
}

}  // namespace
}  // namespace mrroc::pick_test
