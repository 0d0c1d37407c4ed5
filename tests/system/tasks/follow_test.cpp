#include <gtest/gtest.h>

#include <cmath>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::follow_test {
namespace {

constexpr const char* kDeployment = "tasks/follow/follow.toml";

/// One step of ForceControl: tick, position, and the force along the tool's z axis.
struct Step {
  double time = 0, y = 0, z = 0, force = 0;
};

/// The last instruction of ForceControl: the motion along the workpiece.
std::vector<Step> way_along(const std::filesystem::path& trace) {
  std::vector<Step> steps;
  std::uint64_t instruction = 0;
  for (const cli::trace::Line& step : steps_of(trace, "ForceControl")) {
    if (step.instruction != instruction) steps.clear();
    instruction = step.instruction;
    const cli::trace::RobotEntry& arm = step.robots.at(0);
    if (arm.wrench.size() == 6)
      steps.push_back({static_cast<double>(arm.tick) * 0.002, arm.pose[1], arm.pose[2], arm.wrench[2]});
  }
  return steps;
}

TEST(Follow, PressesACurvedSurfaceWith10NewtonAt50MillimetresPerSecond) {
  const ScratchFolder folder;
  const auto trace = expect_equal_runs(kDeployment, folder).trace;

  const std::vector<Step> steps = way_along(trace);
  ASSERT_GT(steps.size(), 100u);
  double squares = 0, lowest = 1e9, highest = -1e9, way = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    squares += std::pow(-steps[i].force - 10, 2);
    lowest = std::min(lowest, steps[i].z);
    highest = std::max(highest, steps[i].z);
    if (i > 0) way += std::hypot(steps[i].y - steps[i - 1].y, steps[i].z - steps[i - 1].z);
  }
  const double error = std::sqrt(squares / static_cast<double>(steps.size()));
  const double speed = way / (steps.back().time - steps.front().time);
  std::printf("force 10 N, error %.2f N RMS, at %.1f mm/s, height between %.1f and %.1f mm\n", error, 1000 * speed,
              1000 * lowest, 1000 * highest);
  EXPECT_LT(error, 1.0);
  EXPECT_GT(speed, 0.049);
  EXPECT_GT(highest - lowest, 0.005) << "the surface is curved";
}

TEST(Follow, AForceLimitStopsTheArmAndTheTaskSaysWhy) {
  const ScratchFolder folder;
  std::string text = text_of(std::filesystem::path(MRROC_SOURCE_DIR) / kDeployment);
  const std::string limit = "force_limit = [40, 40, 60]", scene = "\"follow.xml\"";
  ASSERT_NE(text.find(limit), std::string::npos);
  text.replace(text.find(limit), limit.size(), "force_limit = [40, 40, 8]");
  text.replace(text.find(scene), scene.size(), "\"" MRROC_SOURCE_DIR "/tasks/follow/follow.xml\"");
  const std::string output = run_mrroc({"run", folder.write("weak.toml", text).string()}, 1);
  EXPECT_NE(output.find("a force limit is passed: axis 3 of the force sensor"), std::string::npos) << output;
  EXPECT_NE(output.find("limit 8"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::follow_test
