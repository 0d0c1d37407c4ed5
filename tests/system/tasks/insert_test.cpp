#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::insert_test {
namespace {

constexpr const char* kDeployment = "tasks/insert/insert.toml";

/// A search and the following insertion: position of the tip beside the hole at the start, its lowest point below that,
/// the largest lateral force.
struct Trial {
  double error = 0, depth = 0, sideways = 0;
};

std::vector<Trial> trials_of(const std::filesystem::path& trace) {
  std::vector<Trial> trials;
  // the two instructions of a trial; the extraction and the next descent are not included
  std::uint64_t searching = 0, going_in = 0;
  double top = 0;
  for (const cli::trace::Line& step : steps_of(trace)) {
    const bool search = step.is_move && step.name == "SpiralSearch";
    const bool force = step.is_move && step.name == "ForceControl";
    if (!search && !force) continue;
    const cli::trace::Numbers &pose = step.robots.at(0).pose, &wrench = step.robots.at(0).wrench;
    const std::uint64_t instruction = step.instruction;
    if (search && instruction != searching) {
      trials.push_back({std::hypot(pose.at(0) - 0.75, pose.at(1)), 0, 0});
      top = pose.at(2);
      searching = instruction;
      going_in = 0;
    }
    if (force && going_in == 0) going_in = instruction;
    if (trials.empty() || (force && instruction != going_in)) continue;
    trials.back().depth = std::max(trials.back().depth, top - pose.at(2));
    if (wrench.size() == 6) trials.back().sideways = std::max(trials.back().sideways, std::hypot(wrench[0], wrench[1]));
  }
  return trials;
}

TEST(Insert, InsertsThePegFromTenPositionsUpTo2MillimetresBesideTheHole) {
  const ScratchFolder folder;
  const auto trace = expect_equal_runs(kDeployment, folder).trace;

  const std::vector<Trial> trials = trials_of(trace);
  ASSERT_EQ(trials.size(), 10u);
  double farthest = 0;
  for (const Trial& trial : trials) {
    std::printf("%.2f mm beside the hole, %.1f mm deep, at most %.1f N sideways\n", 1000 * trial.error,
                1000 * trial.depth, trial.sideways);
    EXPECT_GT(trial.depth, 0.024);
    EXPECT_LT(trial.sideways, 30);
    farthest = std::max(farthest, trial.error);
  }
  EXPECT_GT(farthest, 0.0015) << "some errors must be large";
}

TEST(Insert, TaskReportsAMissingHole) {
  const ScratchFolder folder;
  const std::filesystem::path tasks = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/insert";
  std::string scene = text_of(tasks / "insert.xml");
  const std::string joint = "<joint name=\"bush_z\"";
  ASSERT_NE(scene.find(joint), std::string::npos);
  scene.insert(scene.find('\n', scene.find(joint)) + 1,
               "<geom class=\"wall\" type=\"cylinder\" size=\"0.015 0.02\"/>\n");  // a plug
  folder.write("insert.xml", scene);
  const std::string output =
      run_mrroc({"run", folder.write("insert.toml", text_of(tasks / "insert.toml")).string()}, 1);
  EXPECT_NE(output.find("there is no hole"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::insert_test
