#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "config/deployment.hpp"
#include "replace.hpp"
#include "sim/scene/model.hpp"
#include "sim/simulation.hpp"
#include "sim/state_file.hpp"
#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::hand_over_test {
namespace {

const std::filesystem::path kTask = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/hand_over";
const std::string kDeployment = (kTask / "hand_over.toml").string();
constexpr int kBars = 3;
constexpr double kFelt = 6.0;          // N, of arm.cpp
constexpr double kWidth = 0.060;       // m, of a bar
constexpr double kTolerance = 0.0015;  // m

/// The task's deployment for a file in another folder.
std::string deployment() {
  std::string text = text_of(kDeployment);
  replace(text, "hand_over.xml", (kTask / "hand_over.xml").string());
  return text;
}

/// A deployment in which the receiver pulls `seconds` after it has gripped.
std::string late_deployment(int seconds) {
  std::string text = deployment();
  const std::size_t receiver = text.find("[robots.receiver]");
  const std::string program = "\"hand_over_arm\"";
  text.replace(text.find(program, receiver), program.size(), "\"" MRROC_BINARY_DIR "/tests/hand_over_late_ecp\"");
  return text + "\n[[answers]]\nquestion = \"How long does the receiver wait?\"\nanswer = \"" +
         std::to_string(seconds) + "\"\n";
}

/// Poses of the bars in the newest of the states that a run has saved: x, y, z (m) and their rotation (rad).
std::vector<Eigen::Vector4d> bars_at_the_end(const std::filesystem::path& states) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(states)) files.insert(entry.path());
  const sim::WorldState state = sim::load_state(*files.rbegin());
  setenv("MRROC_PROGRAMS", MRROC_BINARY_DIR "/bin", 1);
  const sim::Model model = sim::load_model(sim::compose(config::load_deployment(kDeployment)));
  std::vector<Eigen::Vector4d> bars;
  for (int bar = 1; bar <= kBars; ++bar) {
    const std::string name = "bar_" + std::to_string(bar);
    const int joint = model->body_jntadr[mj_name2id(model.get(), mjOBJ_BODY, name.c_str())];
    const double* at = state.positions.data() + model->jnt_qposadr[joint];
    bars.emplace_back(at[0], at[1], at[2], 2 * std::atan2(at[6], at[3]));
  }
  return bars;
}

void expect_in_place(const std::filesystem::path& states) {
  const std::vector<Eigen::Vector4d> bars = bars_at_the_end(states);
  for (int bar = 0; bar < kBars; ++bar) {
    const Eigen::Vector4d& at = bars[static_cast<std::size_t>(bar)];
    std::printf("bar %d lies %.2f mm off its position, turned by %.4f rad\n", bar + 1,
                1000 * std::hypot(at[0] - (0.9 - 0.1 * bar), at[1] - 0.5), at[3]);
    EXPECT_NEAR(at[0], 0.9 - 0.1 * bar, kTolerance);
    EXPECT_NEAR(at[1], 0.5, kTolerance);
    EXPECT_NEAR(at[2], 0.57, 0.001) << "lies on the table";
    EXPECT_NEAR(std::sin(at[3]), 0, 0.01);
  }
}

/// Data of the hand-overs from a trace.
struct HandOvers {
  std::vector<Tick> felt;             // when the giver detected a pull
  double largest_before = 0;          // N, the largest pull in the steps before
  std::vector<Tick> opened;           // when its hand was commanded to open
  double last_opening = 0, last = 0;  // m, of its hand, commanded; s, the newest step of the giver
};

HandOvers hand_overs_of(const std::filesystem::path& trace) {
  HandOvers found;
  for (const cli::trace::Line& step : steps_of(trace)) {
    const Tick tick = step.tick;
    const cli::trace::ConditionEntry* const pulled = condition_in(step, "pulled");
    if (step.process == "giver" && pulled != nullptr) {
      const auto has_wrench = [](const cli::trace::RobotEntry& robot) { return !robot.wrench.empty(); };
      const auto arm = std::find_if(step.robots.begin(), step.robots.end(), has_wrench);
      if (arm == step.robots.end()) throw std::runtime_error("a step of the giver without a wrench");
      const double pull = -arm->wrench.at(1);
      found.last = 0.002 * static_cast<double>(tick);
      if (pulled->value) {
        EXPECT_GT(pull, kFelt);
        found.felt.push_back(tick);
      } else {
        found.largest_before = std::max(found.largest_before, pull);
      }
    }
    const cli::trace::RobotEntry* const hand = robot_in(step, "giver_hand");
    if (hand == nullptr) continue;
    const double opening = hand->desired.at(0);
    if (found.last > 0 && found.last_opening < kWidth && opening >= kWidth) found.opened.push_back(tick);
    found.last_opening = opening;
  }
  return found;
}

TEST(ServoChannel, ThreeBarsAreHandedOverOnAPullEquallyInEveryRun) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs(kDeployment, folder, MrrocRun::kLongPatience);
  for (const std::string& output : runs.outputs)
    EXPECT_NE(output.find("bar 3: the giver detects the pull and lets go"), std::string::npos) << output;
  expect_in_place(runs.states);

  const HandOvers found = hand_overs_of(runs.trace);
  ASSERT_EQ(found.felt.size(), static_cast<std::size_t>(kBars));
  ASSERT_EQ(found.opened.size(), static_cast<std::size_t>(kBars));
  EXPECT_LE(found.largest_before, kFelt);
  for (std::size_t bar = 0; bar < found.felt.size(); ++bar) {
    EXPECT_GT(found.opened[bar], found.felt[bar]);
    EXPECT_LT(found.opened[bar], found.felt[bar] + 750) << "the fingers are slow";
  }
}

TEST(ServoChannel, BarsInAnotherOrderReachTheirPositionsToo) {
  const ScratchFolder folder;
  std::array<std::filesystem::path, 2> states;
  std::array<std::vector<std::string>, 2> runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const int seed = i == 0 ? 11 : 31;
    std::string text = deployment();
    for (int bar = 1; bar <= kBars; ++bar)
      replace(text, std::string{"seed = "} + std::to_string(bar) + "\n",
              std::string{"seed = "} + std::to_string(seed + bar) + "\n");
    const std::string name = std::to_string(seed);
    states[i] = folder.path() / name;
    std::filesystem::create_directory(states[i]);
    runs[i] = {"run", folder.write(name + ".toml", text).string(), "--quiet", "--snapshots", states[i].string()};
  }
  run_two(runs, 0, MrrocRun::kLongPatience);
  for (const auto& folder_of_run : states) expect_in_place(folder_of_run);
}

TEST(ServoChannel, GiverWithoutAPullReportsItAndKeepsTheBar) {
  const ScratchFolder folder;
  const auto states = folder.path() / "states", trace = folder.path() / "run.mcap";
  std::filesystem::create_directory(states);
  const std::string output = run_mrroc({"run", folder.write("hand_over.toml", late_deployment(60)).string(), "--record",
                                        trace.string(), "--snapshots", states.string()},
                                       1, MrrocRun::kLongPatience);
  EXPECT_NE(output.find("the bar was not pulled"), std::string::npos) << output;
  const HandOvers found = hand_overs_of(trace);
  EXPECT_TRUE(found.felt.empty());
  EXPECT_LT(found.largest_before, kFelt);
  EXPECT_TRUE(found.opened.empty());
  EXPECT_LT(found.last_opening, kWidth);
  EXPECT_NEAR(bars_at_the_end(states).front()[2], 0.85, 0.002);
}

TEST(ServoChannel, LaterPullIsDetectedLater) {
  constexpr Tick kLater = 2500;
  const ScratchFolder folder;
  const std::string end = "\n[[events]]\ntick = 24000\ncommand = \"stop\"\n";
  const auto run = [&](int seconds) -> std::vector<std::string> {
    const std::string name = std::to_string(seconds);
    return {"run", folder.write(name + ".toml", late_deployment(seconds) + end).string(), "--quiet", "--record",
            folder.path() / (name + ".mcap")};
  };
  run_two({run(0), run(5)}, 5, MrrocRun::kLongPatience);
  std::vector<Tick> felt;
  for (const char* name : {"0", "5"}) {
    const HandOvers found = hand_overs_of(folder.path() / (std::string{name} + ".mcap"));
    ASSERT_EQ(found.felt.size(), 1u);
    ASSERT_EQ(found.opened.size(), 1u);
    EXPECT_GT(found.opened[0], found.felt[0]);
    felt.push_back(found.felt[0]);
  }
  EXPECT_NEAR(static_cast<double>(felt[1] - felt[0]), kLater, 150);
}

}  // namespace
}  // namespace mrroc::test::hand_over_test
