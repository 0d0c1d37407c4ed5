#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "config/deployment.hpp"
#include "sim/removed_material.hpp"
#include "sim/scene/model.hpp"
#include "sim/simulation.hpp"
#include "sim/state_file.hpp"
#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "tasks/engraving/board.hpp"
#include "text_of.hpp"

namespace mrroc::test::engraving_test {
namespace {

constexpr const char* kDeployment = "tasks/engraving/engraving.toml";
constexpr double kDepth = 0.001;

/// Depths of the cutter's tip, and their statistics.
struct Depths {
  std::vector<double> values;

  double error() const {
    double squares = 0;
    for (const double depth : values) squares += std::pow(depth - kDepth, 2);
    return std::sqrt(squares / static_cast<double>(values.size()));
  }
  double worst() const {
    double worst = 0;
    for (const double depth : values) worst = std::max(worst, std::abs(depth - kDepth));
    return worst;
  }
};

/// Data of the strokes from a trace: the depths of the measured tip, and the ticks of each instruction.
struct Strokes {
  Depths measured;
  std::vector<std::pair<double, double>> ticks;
  double length = 0;  ///< m

  bool carved_at(double tick) const {
    return std::any_of(ticks.begin(), ticks.end(),
                       [tick](const auto& one) { return one.first <= tick && tick <= one.second; });
  }
};

Strokes strokes_of(const std::filesystem::path& trace) {
  Strokes strokes;
  std::uint64_t instruction = 0;
  Eigen::Vector3d before;
  for (const cli::trace::Line& step : steps_of(trace, "PoseSpline")) {
    const cli::trace::Numbers& pose = step.robots.at(0).pose;
    const auto tick = static_cast<double>(step.tick);
    strokes.measured.values.push_back(board_depth({pose.at(0), pose.at(1), pose.at(2)}));
    const Eigen::Vector3d place(pose.at(0), pose.at(1), pose.at(2));
    if (step.instruction != instruction)
      strokes.ticks.emplace_back(tick, tick);
    else
      strokes.length += (place - before).norm();
    before = place;
    strokes.ticks.back().second = tick;
    instruction = step.instruction;
  }
  return strokes;
}

/// Depths of the cutter's tip in the simulated world during the strokes.
Depths true_depths(const std::filesystem::path& states, const Strokes& strokes) {
  setenv("MRROC_PROGRAMS", MRROC_BINARY_DIR "/bin", 1);
  const auto deployment = config::load_deployment(std::filesystem::path(MRROC_SOURCE_DIR) / kDeployment);
  const sim::Model model = sim::load_model(sim::compose(deployment));
  const int head = model->jnt_qposadr[model->body_jntadr[mj_name2id(model.get(), mjOBJ_BODY, "head")]];
  Depths depths;
  for (const auto& entry : std::filesystem::directory_iterator(states)) {
    if (entry.path().extension() != ".state") continue;
    const sim::WorldState state = sim::load_state(entry.path());
    if (!strokes.carved_at(static_cast<double>(state.tick))) continue;
    const double* at = state.positions.data() + head;
    depths.values.push_back(board_depth(Eigen::Vector3d(at[0], at[1], at[2] - 0.6)));
  }
  return depths;
}

/// Volume of the wood that the pictures of the run show as gone, m^3.
double carved_volume(const std::filesystem::path& states) {
  const auto deployment = config::load_deployment(std::filesystem::path(MRROC_SOURCE_DIR) / kDeployment);
  const sim::Model model = sim::load_model(sim::compose(deployment));
  const int wood = mj_name2id(model.get(), mjOBJ_HFIELD, "wood");
  const int rows = model->hfield_nrow[wood], columns = model->hfield_ncol[wood];
  const float* const height = model->hfield_data + model->hfield_adr[wood];
  const auto sum = [&] { return std::accumulate(height, height + rows * columns, 0.0); };
  const double whole = sum();
  sim::remove_material(*model, deployment.sim->scene, states / "all.state", kNever);
  const double* const size = model->hfield_size + 4 * wood;
  return (whole - sum()) * size[2] * 4 * size[0] * size[1] / ((rows - 1) * (columns - 1));
}

/// The deployment with another inscription for the machine, in `folder`.
std::filesystem::path deployment_with(const ScratchFolder& folder, const std::string& what,
                                      const std::string& instead) {
  const std::filesystem::path task = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/engraving";
  std::string states = text_of(task / "states.toml"), deployment = text_of(task / "engraving.toml");
  const std::string scene = "\"engraving.xml\"";
  EXPECT_NE(states.find(what), std::string::npos) << what;
  states.replace(states.find(what), what.size(), instead);
  deployment.replace(deployment.find(scene), scene.size(), "\"" MRROC_SOURCE_DIR "/tasks/engraving/engraving.xml\"");
  folder.write("states.toml", states);
  return folder.write("engraving.toml", deployment);
}

TEST(Engraving, CarvesTheInscriptionToATenthOfAMillimetreIntoAMeasuredBoard) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs(kDeployment, folder, MrrocRun::kLongPatience);
  for (const std::string& output : runs.outputs)
    EXPECT_NE(output.find("touched 44 times"), std::string::npos) << output;

  const Strokes strokes = strokes_of(runs.trace);
  ASSERT_GT(strokes.measured.values.size(), 1000u);
  EXPECT_EQ(strokes.ticks.size(), 16u) << "parts of strokes between corners";
  const Depths truth = true_depths(runs.states, strokes);
  ASSERT_GT(truth.values.size(), 100u);
  std::printf("depth 1 mm: error %.3f mm RMS, %.3f mm at most as measured; %.3f mm RMS, %.3f mm at most in the world\n",
              1000 * strokes.measured.error(), 1000 * strokes.measured.worst(), 1000 * truth.error(),
              1000 * truth.worst());
  EXPECT_LT(strokes.measured.error(), 1e-4);
  EXPECT_LT(truth.error(), 1e-4);

  // a groove of a nose of 3 mm, 1 mm deep; where strokes meet they share some
  constexpr double kSection = 2.063e-6;
  const double volume = carved_volume(runs.states);
  std::printf("%.0f mm of strokes, %.0f mm^3 of wood removed\n", 1e3 * strokes.length, 1e9 * volume);
  EXPECT_GT(volume, 0.8 * strokes.length * kSection);
  EXPECT_LT(volume, 1.05 * strokes.length * kSection);
}

TEST(Engraving, BoardAssumedFlatIsCarvedMillimetresWrong) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "run.mcap";
  const auto deployment = deployment_with(folder, "columns = 11, rows = 4", "columns = 1, rows = 1");
  run_mrroc({"run", deployment.string(), "--quiet", "--record", trace.string()}, 0, MrrocRun::kLongPatience);
  const Strokes strokes = strokes_of(trace);
  ASSERT_EQ(strokes.ticks.size(), 16u);
  std::printf("assumed flat: error %.3f mm RMS, %.3f mm at most\n", 1000 * strokes.measured.error(),
              1000 * strokes.measured.worst());
  EXPECT_GT(strokes.measured.error(), 1e-3);
}

TEST(Engraving, LetterWithoutStrokesIsReportedBeforeAnyMotion) {
  const ScratchFolder folder;
  const auto deployment = deployment_with(folder, "MRROC++", "MRROC%");
  const std::string output = run_mrroc({"run", deployment.string(), "--quiet"}, 1);
  EXPECT_NE(output.find("no strokes for the character '%'"), std::string::npos) << output;
}

TEST(Engraving, TaskReportsAMissingBoard) {
  const ScratchFolder folder;
  const auto deployment = deployment_with(folder, "columns = 11", "columns = 11");
  const std::filesystem::path task = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/engraving";
  std::string scene = text_of(task / "engraving.xml"), text = text_of(deployment);
  const std::string pose = "pos=\"0.05 0 0.044992132\"", file = "file=\"board.hfield\"";
  ASSERT_NE(scene.find(pose), std::string::npos);
  for (std::size_t at = scene.find(pose); at != std::string::npos; at = scene.find(pose))
    scene.replace(at, pose.size(), "pos=\"0.05 0 -0.2\"");
  scene.replace(scene.find(file), file.size(), "file=\"" + (task / "board.hfield").string() + "\"");
  const std::string old_scene = "\"" MRROC_SOURCE_DIR "/tasks/engraving/engraving.xml\"";
  text.replace(text.find(old_scene), old_scene.size(), "\"engraving.xml\"");
  folder.write("engraving.xml", scene);
  const std::string output = run_mrroc({"run", folder.write("engraving.toml", text).string(), "--quiet"}, 1);
  EXPECT_NE(output.find("no board under the probe"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::engraving_test
