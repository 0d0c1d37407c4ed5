#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "config/deployment.hpp"
#include "sim/scene/model.hpp"
#include "sim/simulation.hpp"
#include "sim/state_file.hpp"
#include "system/equal_runs.hpp"

namespace mrroc::test::track_and_pick_test {
namespace {

constexpr const char* kDeployment = "tasks/track_and_pick/track_and_pick.toml";
constexpr int kParts = 20;

/// The newest of the states that a run has saved.
sim::WorldState last_state(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path());
  return sim::load_state(*files.rbegin());
}

/// Number of parts at one of the 20 positions on the table: rows of five, two deep, two high.
int parts_in_place(const sim::WorldState& state) {
  setenv("MRROC_PROGRAMS", MRROC_BINARY_DIR "/bin", 1);
  const auto deployment = config::load_deployment(std::filesystem::path(MRROC_SOURCE_DIR) / kDeployment);
  const sim::Model model = sim::load_model(sim::compose(deployment));
  std::set<int> taken;
  for (const std::string& part : deployment.sim->feeders.at(0).parts) {
    const int joint = model->body_jntadr[mj_name2id(model.get(), mjOBJ_BODY, part.c_str())];
    const double* at = state.positions.data() + model->jnt_qposadr[joint];
    const double column = (at[0] - 0.46) / 0.08, row = (0.61 - at[1]) / 0.09, layer = (at[2] - 0.5725) / 0.045;
    const double off = std::hypot(0.08 * (column - std::round(column)), 0.09 * (row - std::round(row)));
    const double turn = 2 * std::atan2(at[6], at[3]);
    EXPECT_LT(off, 0.005) << part << " at " << at[0] << " " << at[1] << " " << at[2];
    EXPECT_LT(std::abs(layer - std::round(layer)), 0.1) << part << " lies at " << at[2];
    EXPECT_LT(std::abs(std::sin(turn)), 0.05) << part << " is turned by " << turn;
    taken.insert(static_cast<int>(std::lround(column) + 5 * std::lround(row) + 10 * std::lround(layer)));
  }
  EXPECT_TRUE(*taken.begin() >= 0 && *taken.rbegin() < kParts);
  return static_cast<int>(taken.size());
}

TEST(TrackAndPick, PicksTwentyOfTwentyPartsFromABeltAt150MillimetresPerSecond) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs(kDeployment, folder, MrrocRun::kLongPatience);
  for (const std::string& output : runs.outputs) {
    for (int part = 1; part <= kParts; ++part) {
      const std::string line = "part " + std::to_string(part) + " picked";
      EXPECT_NE(output.find(line), std::string::npos) << line;
    }
  }
  EXPECT_EQ(parts_in_place(last_state(runs.states)), kParts);
}

}  // namespace
}  // namespace mrroc::test::track_and_pick_test
