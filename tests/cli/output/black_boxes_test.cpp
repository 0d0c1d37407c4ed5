#include "cli/output/black_boxes.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "cli/trace/encoded_line.hpp"
#include "cli/trace/trace_steps.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::black_boxes_test {
namespace {

/// A run of the tasks "arm" and "mp", whose last steps are the lines of an example.
class BlackBoxesTest : public testing::Test {
 protected:
  BlackBoxesTest() {
    deployment.name = "t";
    for (const char* name : {"arm", "mp"}) plan.push_back({.name = name, .program = {}, .has_task = true});
  }
  /// The tasks record the lines of the example.
  void make_steps(const BlackBoxes& boxes) const {
    for (const trace::Item& item : example.items) {
      const auto* const line = std::get_if<trace::Line>(&item);
      if (line == nullptr || boxes.fd_of(line->process) < 0) continue;
      process::SharedBlackBox::attach(boxes.fd_of(line->process)).record(line->made, trace::encoded_line(*line));
    }
  }
  static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  task_test::ScratchFolder folder;
  config::Deployment deployment;
  const std::string text = "[deployment]\nname = \"t\"\n";
  std::vector<PlannedProcess> plan;
  trace::TraceSteps example = trace::example_trace();
};

TEST_F(BlackBoxesTest, RecordOfARunHasTheStepsOfAllTasks) {
  const BlackBoxes boxes(folder / "boxes", deployment, text, plan);
  make_steps(boxes);
  const std::string reply = boxes.record(folder / "x/../now.mcap");
  EXPECT_NE(reply.find(" steps of arm, mp; black box: " + (folder / "now.mcap").string()), std::string::npos) << reply;
  const trace::Found found = trace::check(folder / "now.mcap");
  EXPECT_EQ(found.text(), "");
  EXPECT_EQ(found.verdict.processes, 2U);
  const std::size_t arm = std::min<std::size_t>(trace::line_count(example, "arm"), 50);
  const std::size_t mp = std::min<std::size_t>(trace::line_count(example, "mp"), 50);
  EXPECT_EQ(found.verdict.lines, arm + mp);
  EXPECT_TRUE(trace::Reader(folder / "now.mcap").black_box());
  EXPECT_EQ(boxes.reported(), "") << "no task has failed";
}

TEST_F(BlackBoxesTest, RecordKeepsFilesThatExist) {
  const BlackBoxes boxes(folder / "boxes", deployment, text, plan);
  make_steps(boxes);
  const std::filesystem::path file = folder.write("kept.mcap", "kept");
  EXPECT_THROW(boxes.record(file), std::runtime_error);
  EXPECT_EQ(text_of(file), "kept");
  for (const char* impossible : {"missing/now.mcap", "kept.mcap/now.mcap", "."}) {
    EXPECT_THROW(boxes.record(folder / impossible), std::runtime_error) << impossible;
  }
}

TEST_F(BlackBoxesTest, RecordWithoutStepsIsRefused) {
  const BlackBoxes early(folder / "boxes", deployment, text, plan);
  EXPECT_THROW(early.record(folder / "now.mcap"), std::logic_error);
  const BlackBoxes none("", deployment, text, plan);
  EXPECT_THROW(none.record(folder / "now.mcap"), std::logic_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "now.mcap"));
}

TEST_F(BlackBoxesTest, RecordNamesTheTasksOfOtherHosts) {
  plan.front().host = "pc";
  const BlackBoxes boxes(folder / "boxes", deployment, text, plan);
  make_steps(boxes);
  const std::string reply = boxes.record(folder / "now.mcap");
  EXPECT_NE(reply.find("steps of mp, without those on other hosts: arm;"), std::string::npos) << reply;
  EXPECT_EQ(trace::check(folder / "now.mcap").text(), "");
}

}  // namespace
}  // namespace mrroc::cli::black_boxes_test
