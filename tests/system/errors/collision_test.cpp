// The column of an IRb-6 swings into a pillar: the robot stops where it is, not where it was to be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mrroc/errors.hpp"
#include "mrroc/testing/motion.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::collision_test {
namespace {

constexpr double kOverrun = 0.005;  // rad
constexpr Tick kLongestStop = 60;   // from the set-point's speed at the collision the stop takes 218 ticks

TEST(Collision, SetPointDoesNotContinueIntoTheObstacle) {
  const ScratchFolder folder;
  folder.write(
      "pillar.xml",
      "<mujoco>\n<compiler angle=\"radian\"/>\n<worldbody>\n"
      "<geom name=\"pillar\" type=\"cylinder\" size=\"0.05 1\" pos=\"0.2 0.75 1\"/>\n</worldbody>\n</mujoco>\n");
  const auto file =
      folder.write("collide.toml",
                   "[deployment]\nname = \"collide\"\nclock = \"lockstep\"\n[robots.arm]\ntype = \"irb6\"\n"
                   "hardware = \"mujoco\"\nprogram = \"" MRROC_BINARY_DIR
                   "/tests/collide_ecp\"\nposition = [0.0, 0.0, 0.7]\n[sim]\nscene = \"pillar.xml\"\n");
  const auto motion_file = folder.path() / "motion";
  const std::string output =
      run_mrroc({"run", file.string(), "--quiet", "--black-box", "", "--motion", motion_file.string()}, 0);
  double way = NAN;
  unsigned long long fault = 0;
  const std::size_t at = output.find("code ");
  ASSERT_NE(at, std::string::npos) << output;
  int code = 0;
  ASSERT_EQ(std::sscanf(output.c_str() + at, "code %d tick %llu set-point %lf", &code, &fault, &way), 3) << output;
  EXPECT_EQ(code, static_cast<int>(ErrorCode::following_error)) << output;
  EXPECT_LE(std::abs(way), kOverrun) << "between the measured column and the end of its stop";

  const task_test::Motion motion = task_test::read_motion(motion_file).at("arm");
  const auto first = static_cast<std::size_t>(std::lower_bound(motion.ticks.begin(), motion.ticks.end(), Tick{fault}) -
                                              motion.ticks.begin());
  ASSERT_LT(first, motion.ticks.size());
  for (std::size_t i = first; i < motion.ticks.size(); ++i)
    ASSERT_LE(motion.positions[i][0] - motion.positions[first][0], kOverrun) << "tick " << motion.ticks[i];
  EXPECT_LE(motion.standstill(), fault + kLongestStop);
}

}  // namespace
}  // namespace mrroc::test::collision_test
