#include "mrroc/testing/run.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "messages/mrroc_msgs/step.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::task_test {
namespace {

/// A command in place of `mrroc` that writes a recording with this step to its argument after `--record`.
RunResult run_that_records(const messages::mrroc_msgs::Step& step) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "made.mcap";
  const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  recording::RecordingWriter writer(fd, 0.002, {{"clock", "lockstep"}}, "");
  writer.write_step(step.process, step.tick, messages::to_cdr(step));
  EXPECT_EQ(writer.close(), 0);
  close(fd);
  const auto command = folder.write(
      "mrroc", "#!/bin/sh\nwhile [ \"$1\" != --record ]; do shift; done\ncp " + file.string() + " \"$2\"\n");
  std::filesystem::permissions(command, std::filesystem::perms::owner_all);
  return DeploymentRun(command, "some.toml").run();
}

TEST(DeploymentRun, HasTheStepsOfTheRecording) {
  messages::mrroc_msgs::Step step;
  step.tick = 248;
  step.process = "arm";
  step.is_move = true;
  step.name = "to the left";
  step.step_number = 3;
  step.robots.resize(1);
  step.robots[0].tick = 240;
  step.ending = messages::mrroc_msgs::Step::CONDITION;
  const auto run = run_that_records(step);
  ASSERT_EQ(run.steps.size(), 1u) << run.output;
  EXPECT_EQ(run.steps[0].tick, 248u);
  EXPECT_EQ(run.steps[0].process, "arm");
  EXPECT_EQ(run.steps[0].instruction, "to the left");
  EXPECT_TRUE(run.steps[0].is_move);
  EXPECT_EQ(run.steps[0].step, 3u);
  EXPECT_EQ(run.steps[0].ending, "condition");
  EXPECT_NE(run.steps[0].json.find("\"name\":\"to the left\""), std::string::npos) << run.steps[0].json;
}

}  // namespace
}  // namespace mrroc::task_test
