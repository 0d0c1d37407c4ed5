// `mrroc trace check` on traces of real runs, unchanged and mutated.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "cli/trace/mutations.hpp"
#include "language/property.hpp"
#include "system/equal_runs.hpp"
#include "text_of.hpp"

namespace mrroc::test::trace_check_test {
namespace {

using cli::trace::check;
using cli::trace::Mutation;
using cli::trace::Random;
using cli::trace::read_trace;
using cli::trace::TraceSteps;

constexpr int kHolds = 0, kViolated = 1, kMalformed = 2;
constexpr int kPlaces = 10;  // places at which each mutation is tried

/// The task press, paused in its search and ended by the operator.
std::filesystem::path press_with_pause(const ScratchFolder& folder) {
  std::string text = text_of(MRROC_SOURCE_DIR "/tasks/press/press.toml");
  const std::string scene = "\"press.xml\"";
  text.replace(text.find(scene), scene.size(), "\"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"");
  for (const char* event :
       {"tick = 1500\ncommand = \"pause\"", "tick = 1700\ncommand = \"resume\"", "tick = 2600\ncommand = \"stop\""})
    text += std::string{"\n[[events]]\n"} + event + "\n";
  return folder.write("press.toml", text);
}

/// Another test runs this task several times and already checks its trace.
bool is_run_by_its_test(const std::string& task) {
  return text_of(MRROC_SOURCE_DIR "/tests/system/tasks/" + task + "_test.cpp").find("expect_equal_runs(") !=
         std::string::npos;
}

/// The tasks with a deployment of their name that no other test runs several times.
std::vector<std::string> other_tasks() {
  std::vector<std::string> names;
  for (const auto& folder : std::filesystem::directory_iterator(MRROC_SOURCE_DIR "/tasks")) {
    const std::string name = folder.path().filename().string();
    if (std::filesystem::exists(folder.path() / (name + ".toml")) && !is_run_by_its_test(name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// "trace_0.mcap: 463 steps of 5 instructions of 1 process: 36 rules hold", and nothing else.
bool says_that_all_rules_hold(std::string output) {
  if (const std::size_t plural = output.find("processes"); plural != std::string::npos) output.erase(plural + 7, 2);
  int steps = 0, instructions = 0, processes = 0, rules = 0, end = 0;
  const int found =
      std::sscanf(output.c_str(), "trace_0.mcap: %d steps of %d instructions of %d process: %d rules hold\n%n", &steps,
                  &instructions, &processes, &rules, &end);
  return found == 4 && end == std::ssize(output) && steps > 0 && instructions > 0 && processes > 0 && rules > 0;
}

/// As if each process had failed at some of its steps: its black box would keep the rules, too.
void expect_laws_of_black_boxes(const TraceSteps& whole) {
  constexpr std::size_t kSteps = 50, kBoxes = 20;
  std::set<std::string> processes;
  for (std::size_t i = 0; i < whole.items.size(); ++i)
    if (whole.is_line(i)) processes.insert(whole.line(i).process);
  for (const std::string& process : processes) {
    const std::size_t lines = cli::trace::line_count(whole, process);
    for (std::size_t place = 0; place < kBoxes; ++place) {
      const std::size_t begin = place * lines / kBoxes;
      const TraceSteps box = cli::trace::black_box_of(whole, process, begin, begin + kSteps);
      EXPECT_EQ(check(box).text(), "") << process << " from line " << begin;
    }
  }
}

class TraceOfTask : public testing::TestWithParam<std::string> {};

TEST_P(TraceOfTask, KeepsEveryRuleAndIsEqualInEveryRun) {
  const ScratchFolder folder;
  const std::string& task = GetParam();
  const auto trace = expect_equal_runs("tasks/" + task + "/" + task + ".toml", folder).trace;
  const std::string output = run_mrroc({"trace", "check", trace.string()}, kHolds);
  EXPECT_TRUE(says_that_all_rules_hold(output)) << output;
  expect_laws_of_black_boxes(read_trace(trace));
}

INSTANTIATE_TEST_SUITE_P(Tasks, TraceOfTask, testing::ValuesIn(other_tasks()),
                         [](const auto& task) { return task.param; });

/// Tries every mutation at some places of a trace. Returns the names of those with a suitable place.
std::set<std::string> spoil(const TraceSteps& original) {
  std::set<std::string> tried;
  fakes::check_property(kPlaces, [&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    for (const Mutation& mutation : cli::trace::all_mutations()) {
      TraceSteps spoilt = original;
      if (!mutation.apply(spoilt, random)) continue;
      tried.insert(mutation.name);
      if (check(spoilt).rules.empty()) RC_FAIL(std::string{mutation.name} + " is not found");
    }
  });
  return tried;
}

TEST(TraceCheck, FindsEveryMutationOfARealTrace) {
  const ScratchFolder folder;
  const auto press = folder.path() / "press.mcap", paused = folder.path() / "paused.mcap",
             pick = folder.path() / "pick.mcap";
  run_mrroc({"run", "tasks/press_mp/press_mp.toml", "--quiet", "--record", press.string()}, 0);
  run_mrroc({"run", press_with_pause(folder).string(), "--quiet", "--record", paused.string()}, 5);
  run_mrroc({"run", "tasks/pick/pick.toml", "--quiet", "--record", pick.string()}, 0);
  std::set<std::string> tried;
  for (const auto& trace : {press, paused, pick}) {
    const TraceSteps original = read_trace(trace);
    ASSERT_TRUE(check(original).rules.empty());
    tried.merge(spoil(original));
  }
  EXPECT_GT(tried.size(), 35U) << "of " << cli::trace::all_mutations().size();
}

TEST(TraceCheck, ReportsViolationsNotesAndMalformedFiles) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "press.mcap", wrong = folder.path() / "wrong.mcap";
  run_mrroc({"run", "tasks/press/press.toml", "--quiet", "--record", trace.string()}, 0);

  TraceSteps spoilt = read_trace(trace);
  for (std::size_t i = 80; i < 100; ++i) spoilt.line(i).tick -= 1;
  spoilt.write(wrong);
  const std::string ten = run_mrroc({"trace", "check", wrong.string()}, kViolated);
  EXPECT_NE(ten.find("wrong.mcap:81: step-tick: tick="), std::string::npos) << ten;
  EXPECT_NE(ten.find("20 violations, the first 10 are shown (--all: every one)"), std::string::npos) << ten;
  EXPECT_EQ(std::count(ten.begin(), ten.end(), '\n'), 11);
  const std::string all = run_mrroc({"trace", "check", "--all", wrong.string()}, kViolated);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 21) << all;

  const std::string bytes = text_of(trace);
  const auto killed = folder.write("killed.mcap", bytes.substr(0, bytes.size() / 2));
  const std::string notes = run_mrroc({"trace", "check", killed.string()}, kHolds);
  EXPECT_NE(notes.find(": note: the steps of process arm stop here"), std::string::npos) << notes;
  EXPECT_NE(notes.find("killed.mcap: note: ends early"), std::string::npos) << notes;
  std::string damaged = bytes;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  EXPECT_NE(run_mrroc({"trace", "check", folder.write("broken.mcap", damaged).string()}, kMalformed)
                .find("broken.mcap: byte "),
            std::string::npos);
  EXPECT_NE(run_mrroc({"trace", "check", "README.md"}, kMalformed).find("README.md: is not an MCAP file"),
            std::string::npos);
  run_mrroc({"trace", "check", "no/such/trace"}, kMalformed);
  run_mrroc({"trace", "check"}, kMalformed);
}

TEST(TraceCheck, ListsItsRules) {
  const std::string output = run_mrroc({"trace", "check", "--rules"}, kHolds);
  EXPECT_NE(output.find("condition-decides"), std::string::npos) << output;
  EXPECT_EQ(output, cli::trace::text_of_rules());
}

}  // namespace
}  // namespace mrroc::test::trace_check_test
