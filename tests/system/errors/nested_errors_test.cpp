// One error, caught at the Move that meets it, in the behaviour, in the MP's task, and only by the process itself:
// robots hold each time, and the black box of the failed process is on disk.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "cli/trace/trace_steps.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::nested_errors_test {
namespace {

const std::string kBelt =
    "type = \"conveyor\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR "/tests/nested_ecp\"\n";

std::filesystem::path deployment(const ScratchFolder& folder) {
  return folder.write("nested.toml", "[deployment]\nname = \"nested\"\n[mp]\nprogram = \"" MRROC_BINARY_DIR
                                     "/tests/nested_mp\"\n[robots.left]\n" +
                                         kBelt + "[robots.right]\n" + kBelt);
}

auto of_process(const std::string& process) {
  return [process](const cli::trace::Line& line) { return line.process == process; };
}

/// The text after `word` in a line, up to the next blank or comma.
std::string after(const std::string& line, const std::string& word) {
  const std::size_t at = line.find(word);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + word.size();
  return line.substr(begin, line.find_first_of(" ,\n", begin) - begin);
}

/// The output behind `text`.
std::string line_of(const std::string& output, const std::string& text) {
  const std::size_t at = output.find(text);
  EXPECT_NE(at, std::string::npos) << "'" << text << "' is missing in\n" << output;
  return at == std::string::npos ? "" : output.substr(at, output.find('\n', at) - at);
}

class NestedErrors : public testing::TestWithParam<const char*> {
 protected:
  NestedErrors() {
    output = run_mrroc({"run", deployment(folder).string(), "--quiet", "--clock", GetParam(), "--record",
                        trace.string(), "--black-box", boxes.string()},
                       1);
  }

  ScratchFolder folder;
  std::filesystem::path trace = folder.path() / "trace.mcap", boxes = folder.path() / "boxes";
  std::string output;
};

TEST_P(NestedErrors, AreCaughtAtAMoveInABehaviourInTheTaskAndInTheShellAndRobotsHold) {
  const auto failed = [](const std::string& process) {
    return [process](const cli::trace::Line& line) {
      return line.process == process && line.ending == StepEnding::non_fatal_error;
    };
  };
  const Steps of_left = steps_where(trace, failed("left")), of_mp = steps_where(trace, failed("mp"));
  ASSERT_EQ(of_left.size(), 4U) << output;
  const std::vector<std::string> places{"caught at the Move", "caught in the behaviour", "caught in a wait of the MP",
                                        "caught in a Move of the MP"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string reported = line_of(output, places[i]);
    EXPECT_EQ(after(reported, "step "), "20") << reported;
    EXPECT_EQ(after(reported, "tick "), std::to_string(of_left[i].tick)) << reported;
    EXPECT_EQ(of_left[i].step, 20U);
    if (i < 2) {
      EXPECT_EQ(after(reported, "moved "), "0.000000") << reported;
      continue;
    }
    EXPECT_EQ(after(reported, "class "), "1") << "non-fatal";
    EXPECT_EQ(after(reported, "code "), "15") << "force_limit";
    EXPECT_EQ(after(reported, "process "), "left");
  }
  EXPECT_NE(output.find("left rests, moved 0.000000 m"), std::string::npos) << output;
  EXPECT_NE(output.find("right rests, moved 0.000000 m"), std::string::npos) << output;
  // the process reports to the operator, and names the files; the box of the behaviour that failed first is kept
  const std::string reason = line_of(output, "mrroc: nested: ");
  ASSERT_FALSE(of_mp.empty()) << output;
  EXPECT_EQ(reason,
            "mrroc: nested: non-fatal error: a force limit is passed: the part was not taken [process mp, step " +
                std::to_string(of_mp.back().step) + ", tick " + std::to_string(of_mp.back().tick) + "]; black box: " +
                (boxes / "nested-left-2.mcap").string() + ", " + (boxes / "nested-mp.mcap").string());
}

TEST_P(NestedErrors, BlackBoxOfAFailedProcessHasTheLastStepsOfItsRecording) {
  for (const std::string process : {"left", "mp"}) {
    const auto box = boxes / ("nested-" + process + ".mcap"), part = folder.path() / (process + ".mcap");
    expect_laws(box);
    const Steps kept = steps_where(box, of_process(process)), all = steps_where(trace, of_process(process));
    ASSERT_EQ(kept.size(), 50U) << process;
    EXPECT_EQ(kept.back().ending, StepEnding::non_fatal_error) << process;
    const auto last = std::find_if(all.begin(), all.end(), [&kept](const cli::trace::Line& line) {
      const cli::trace::Line& newest = kept.back();
      return line.instruction == newest.instruction && line.step == newest.step && line.ending == newest.ending;
    });
    ASSERT_NE(last, all.end()) << process;
    const auto place = static_cast<std::size_t>(last - all.begin());
    ASSERT_GE(place, 50U) << process << ": no step is missing";
    cli::trace::black_box_of(cli::trace::read_trace(trace), process, place - 49, place + 1).write(part);
    run_mrroc({"trace", "diff", box.string(), part.string()}, 0);
    EXPECT_EQ(trace_hash(box), trace_hash(part)) << process;
  }
  // the MP's has the steps of both Moves that continued when one failed
  const auto box = boxes / "nested-mp.mcap";
  for (const char* robot : {"left", "right"}) {
    const auto has_it = [robot](const cli::trace::Line& line) { return robot_in(line, robot) != nullptr; };
    EXPECT_FALSE(steps_where(box, has_it).empty()) << robot;
  }
  EXPECT_FALSE(std::filesystem::exists(boxes / "nested-right.mcap")) << "its task has not failed";
}

INSTANTIATE_TEST_SUITE_P(Clocks, NestedErrors, testing::Values("lockstep", "real"),
                         [](const auto& test) { return std::string(test.param); });

TEST(BlackBoxOption, EmptyFolderDisablesIt) {
  const ScratchFolder folder;
  const auto file = deployment(folder);
  const std::string none = run_mrroc({"run", file.string(), "--quiet", "--black-box", ""}, 1);
  EXPECT_EQ(none.find("black box"), std::string::npos) << none;
}

}  // namespace
}  // namespace mrroc::test::nested_errors_test
