// One error, caught at the Move that meets it, in the behaviour, in the MP's task, and only by the process itself:
// robots hold each time, and the black box of the failed process is on disk.
#include <gtest/gtest.h>

#include <vector>

#include "system/mrroc_run.hpp"
#include "system/trace_line.hpp"

namespace mrroc::test::nested_errors_test {
namespace {

const std::string kBelt =
    "type = \"conveyor\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR "/tests/nested_ecp\"\n";

std::filesystem::path deployment(const ScratchFolder& folder) {
  return folder.write("nested.toml", "[deployment]\nname = \"nested\"\n[mp]\nprogram = \"" MRROC_BINARY_DIR
                                     "/tests/nested_mp\"\n[robots.left]\n" +
                                         kBelt + "[robots.right]\n" + kBelt);
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
    output = run_mrroc({"run", deployment(folder).string(), "--quiet", "--clock", GetParam(), "--trace", trace.string(),
                        "--black-box", boxes.string()},
                       1);
  }

  ScratchFolder folder;
  std::filesystem::path trace = folder.path() / "trace", boxes = folder.path() / "boxes";
  std::string output;
};

TEST_P(NestedErrors, AreCaughtAtAMoveInABehaviourInTheTaskAndInTheShellAndRobotsHold) {
  const auto ends = lines_with(trace, "end=non_fatal_error");
  std::vector<std::string> of_left;
  for (const std::string& line : ends)
    if (line.find("process=left") != std::string::npos) of_left.push_back(line);
  ASSERT_EQ(of_left.size(), 4U) << output;
  const std::vector<std::string> places{"caught at the Move", "caught in the behaviour", "caught in a wait of the MP",
                                        "caught in a Move of the MP"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string reported = line_of(output, places[i]);
    EXPECT_EQ(after(reported, "step "), "20") << reported;
    EXPECT_EQ(after(reported, "tick "), after(of_left[i], "tick=")) << reported << "\n" << of_left[i];
    EXPECT_EQ(after(of_left[i], " step="), "20");
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
  std::string of_mp;
  for (const std::string& line : ends)
    if (line.find("process=mp") != std::string::npos) of_mp = line;
  EXPECT_EQ(reason,
            "mrroc: nested: non-fatal error: a force limit is passed: the part was not taken [process mp, step " +
                after(of_mp, " step=") + ", tick " + after(of_mp, "tick=") + "]; black box: " +
                (boxes / "nested-left-2.trace").string() + ", " + (boxes / "nested-mp.trace").string());
}

TEST_P(NestedErrors, BlackBoxOfAFailedProcessHasTheLastLinesOfItsTrace) {
  for (const std::string process : {"left", "mp"}) {
    const auto box = boxes / ("nested-" + process + ".trace");
    expect_laws(box);
    const auto kept = lines_with(box, " process=" + process + " "),
               all = lines_with(trace, " process=" + process + " ");
    ASSERT_EQ(kept.size(), 50U) << process;
    EXPECT_NE(kept.back().find("end=non_fatal_error"), std::string::npos) << kept.back();
    const auto last = std::find(all.begin(), all.end(), kept.back());
    ASSERT_NE(last, all.end()) << process;
    ASSERT_GE(last - all.begin(), 50) << process << ": no line is missing";
    EXPECT_EQ(kept, std::vector<std::string>(last - 49, last + 1)) << process;
  }
  // the MP's has the steps of both Moves that continued when one failed
  const auto box = boxes / "nested-mp.trace";
  EXPECT_FALSE(lines_with(box, " robot=left ").empty());
  EXPECT_FALSE(lines_with(box, " robot=right ").empty());
  EXPECT_FALSE(std::filesystem::exists(boxes / "nested-right.trace")) << "its task has not failed";
}

INSTANTIATE_TEST_SUITE_P(Clocks, NestedErrors, testing::Values("lockstep", "real"),
                         [](const auto& test) { return std::string(test.param); });

TEST(BlackBoxOption, EmptyFolderDisablesItAndAnInvalidFolderIsReported) {
  const ScratchFolder folder;
  const auto file = deployment(folder);
  const std::string none = run_mrroc({"run", file.string(), "--quiet", "--black-box", ""}, 1);
  EXPECT_EQ(none.find("black box"), std::string::npos) << none;
  const auto blocked = folder.write("blocked", "a file");
  const std::string reported = run_mrroc({"run", file.string(), "--quiet", "--black-box", blocked.string()}, 1);
  EXPECT_NE(reported.find("cannot write the black box " + (blocked / "nested-mp.trace").string()), std::string::npos)
      << reported;
  EXPECT_EQ(reported.find("; black box: "), std::string::npos) << reported;
}

}  // namespace
}  // namespace mrroc::test::nested_errors_test
