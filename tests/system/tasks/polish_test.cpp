#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::polish_test {
namespace {

using Eigen::Vector3d;

constexpr const char* kDeployment = "tasks/polish/polish.toml";

struct Step {
  double time = 0, force = 0;  // s; N along the tool's z
  Vector3d place, axis;        // of the tool, m
};

/// The steps of the Moves with a generator.
std::vector<Step> steps_in(const std::filesystem::path& trace, const std::string& generator) {
  std::vector<Step> steps;
  for (const cli::trace::Line& line : steps_of(trace, generator)) {
    const cli::trace::RobotEntry& arm = line.robots.at(0);
    const cli::trace::Numbers& p = arm.pose;
    if (arm.wrench.size() != 6) continue;
    const Eigen::Quaterniond turn(p[3], p[4], p[5], p[6]);
    steps.push_back(
        {0.002 * static_cast<double>(arm.tick), arm.wrench[2], {p[0], p[1], p[2]}, turn * Vector3d::UnitZ()});
  }
  return steps;
}

TEST(Polish, PressesTheWorkpieceAlongLinesWithItsToolAlongTheNormal) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs(kDeployment, folder, MrrocRun::kLongPatience);
  ASSERT_FALSE(testing::Test::HasFailure());
  const std::string& output = runs.outputs[0];
  std::size_t touched = 0;
  for (std::size_t at = output.find("touched ("); at != std::string::npos; at = output.find("touched (", at + 1))
    ++touched;
  EXPECT_EQ(touched, 9u) << output;

  const std::vector<Step> lines = steps_in(runs.trace, "SurfaceFollowing");
  ASSERT_GT(lines.size(), 300u);
  const Vector3d centre(0.79, 0.01, -0.58);
  double squares = 0, leaning = 0, length = 0;
  int settled = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    length += (lines[i].place - lines[i - 1].place).norm();
    if (lines[i].time < lines.front().time + 2) continue;
    ++settled;
    squares += std::pow(-lines[i].force - 8, 2);
    leaning = std::max(leaning, std::acos(-lines[i].axis.dot((lines[i].place - centre).normalized())));
  }
  std::printf("lines of %.0f mm: force 8 N, error %.2f N RMS, z axis at most %.1f degrees off the normal\n",
              1000 * length, std::sqrt(squares / settled), 57.3 * leaning);
  EXPECT_GT(length, 0.47);
  EXPECT_LT(std::sqrt(squares / settled), 1.0);
  EXPECT_LT(leaning, 0.09);

  const std::vector<Step> circle = steps_in(runs.trace, "Impedance");
  ASSERT_GT(circle.size(), 300u);
  for (const Step& step : circle) {
    if (step.time < circle.front().time + 1) continue;
    EXPECT_NEAR(std::hypot(step.place.x() - 0.80, step.place.y()), 0.03, 0.004);
    EXPECT_GT(-step.force, 3);
    EXPECT_LT(-step.force, 10);
  }
}

TEST(Polish, TaskReportsAMissingWorkpiece) {
  const ScratchFolder folder;
  const std::filesystem::path tasks = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/polish";
  std::string scene = text_of(tasks / "polish.xml");
  const std::string geom = "<geom name=\"workpiece\"";
  ASSERT_NE(scene.find(geom), std::string::npos);
  scene.insert(scene.find(geom) + geom.size(), " contype=\"0\" conaffinity=\"0\"");
  folder.write("polish.xml", scene);
  const std::string output =
      run_mrroc({"run", folder.write("polish.toml", text_of(tasks / "polish.toml")).string()}, 1);
  EXPECT_NE(output.find("there is no workpiece"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::polish_test
