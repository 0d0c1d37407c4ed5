// The task teach: poses from jogging and hand guiding are saved, loaded and replayed.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::teach_test {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

constexpr const char* kDeployment = "tasks/teach/teach.toml";

/// Data of one Move of the arm: the generator's name and the measured tool at every step.
struct Motion {
  std::string name;
  Places places;
};

std::vector<Motion> motions_of_arm(const std::filesystem::path& trace) {
  std::vector<Motion> motions;
  std::uint64_t instruction = 0;
  for (const cli::trace::Line& step : steps_of(trace)) {
    if (step.process != "arm" || !step.is_move) continue;
    if (step.instruction != instruction) motions.push_back({step.name, {}});
    instruction = step.instruction;
    const cli::trace::Numbers& pose = step.robots.at(0).pose;
    motions.back().places.emplace_back(pose.at(0), pose.at(1), pose.at(2));
  }
  return motions;
}

/// The positions of every motion of this name.
std::vector<Places> named(const std::vector<Motion>& motions, const std::string& name) {
  std::vector<Places> found;
  for (const Motion& motion : motions)
    if (motion.name == name) found.push_back(motion.places);
  return found;
}

/// Distance from the line through the positions of a path.
double distance(const Vector3d& place, const Places& way) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3d leg = way[i] - way[i - 1], off = place - way[i - 1];
    const double share = leg.squaredNorm() > 0 ? std::clamp(off.dot(leg) / leg.squaredNorm(), 0.0, 1.0) : 0;
    nearest = std::min(nearest, (off - share * leg).norm());
  }
  return nearest;
}

double farthest(const Places& places, const Places& way) {
  double most = 0;
  for (const Vector3d& place : places) most = std::max(most, distance(place, way));
  return most;
}

TEST(Teach, TaughtPathIsReplayed) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs(kDeployment, folder, MrrocRun::kLongPatience);
  ASSERT_FALSE(testing::Test::HasFailure());
  EXPECT_NE(runs.outputs[0].find("the handle weighs 0.4"), std::string::npos) << runs.outputs[0];
  const std::vector<Motion> motions = motions_of_arm(runs.trace);
  const auto led = named(motions, "LeadThrough + TeachIn"), replays = named(motions, "Replay");
  ASSERT_EQ(led.size(), 1u);
  ASSERT_EQ(replays.size(), 2u);

  // jogged positions of the handle: at home, 80 mm along x, -60 mm along the tool's y and 50 along its z, which points
  // down
  for (const Vector3d& place : {Vector3d(1.0, 0, 0), Vector3d(1.08, 0, 0), Vector3d(1.08, 0.06, -0.05)}) {
    EXPECT_LT(distance(place, replays[0]), 1e-3) << place.transpose();
  }

  double length = 0;
  for (std::size_t i = 1; i < led[0].size(); ++i) length += (led[0][i] - led[0][i - 1]).norm();
  EXPECT_GT(length, 0.5);
  const auto begin = std::find_if(replays[1].begin(), replays[1].end(),
                                  [&](const Vector3d& place) { return (place - led[0].front()).norm() < 1e-3; });
  const Places way(begin, replays[1].end());
  ASSERT_GT(way.size(), 100u);
  EXPECT_LT(farthest(way, led[0]), 1e-3);
  EXPECT_LT(farthest(led[0], way), 1e-3) << "in the other direction: no position is missing";
}

// the weight of the handle is compensated and does not move the tool
TEST(Teach, ReleasedToolDoesNotMove) {
  const ScratchFolder folder;
  const std::filesystem::path task = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/teach";
  std::string scene = text_of(task / "teach.xml");
  const std::string grip = "gainprm=\"0 -400 -20\"";
  ASSERT_NE(scene.find(grip), std::string::npos);
  scene.replace(scene.find(grip), grip.size(), "gainprm=\"0 0 0\"");
  folder.write("teach.xml", scene);
  const auto trace = folder.path() / "run.mcap";
  run_mrroc(
      {"run", folder.write("teach.toml", text_of(task / "teach.toml")).string(), "--quiet", "--record", trace.string()},
      0, 600);
  const auto led = named(motions_of_arm(trace), "LeadThrough + TeachIn");
  ASSERT_EQ(led.size(), 1u);
  ASSERT_GT(led[0].size(), 1000u);
  // the sensor's noise and the arm's oscillation move it by a millimetre or two in 24 s
  for (const Vector3d& place : led[0]) ASSERT_LT((place - led[0].front()).norm(), 5e-3);
}

}  // namespace
}  // namespace mrroc::test::teach_test
