#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr int kTaskFailed = 1;
constexpr int kUsage = 2;
constexpr int kSystem = 4;

void expect_text(const std::string& output, const std::string& text) {
  EXPECT_NE(output.find(text), std::string::npos) << "'" << text << "' is missing in\n" << output;
}

/// A deployment of one arm with loopback drives whose program does what the deployment's name says.
std::string run_faulty(const std::string& kind, int expected) {
  const ScratchFolder folder;
  const auto file = folder.write(kind + ".toml", "[deployment]\nname = \"" + kind +
                                                     "\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n"
                                                     "program = \"" MRROC_BINARY_DIR "/tests/faulty_ecp\"\n");
  return run_mrroc({"run", file.string()}, expected);
}

TEST(WrongInput, OfTheCommandLine) {
  expect_text(run_mrroc({"run"}, kUsage), "FILE is required");
  expect_text(run_mrroc({"run", "tasks/press/press.toml", "--clocks", "real"}, kUsage), "--clocks");
  expect_text(run_mrroc({"run", "tasks/press/press.toml", "--clock", "fast"}, kUsage), "fast");
  expect_text(run_mrroc({"run", "no/such/file.toml"}, kUsage), "no/such/file.toml");
  expect_text(run_mrroc({"trace", "hash", "README.md"}, kUsage), "README.md:1: is no trace");
  expect_text(run_mrroc({"trace", "hash", "no/such/trace"}, kUsage), "no/such/trace");
}

TEST(WrongInput, ADeploymentIsRefusedWithItsLineAndNothingIsStarted) {
  const ScratchFolder folder;
  const auto file = folder.write("wrong.toml", "[deployment]\nname = \"wrong\"\nclock = \"fast\"\n");
  const std::string output = run_mrroc({"run", file.string()}, kUsage);
  expect_text(output, "wrong.toml:3: deployment.clock: 'fast'");
  EXPECT_EQ(output.find("ready"), std::string::npos) << output;
  expect_text(run_mrroc({"run", "--check", file.string()}, kUsage), "wrong.toml:3: deployment.clock");
}

TEST(WrongInput, CheckStartsNothing) {
  const std::string output = run_mrroc({"run", "--check", "tasks/press/press.toml"}, 0);
  expect_text(output, "press: lockstep");
  EXPECT_EQ(output.find("ready"), std::string::npos) << output;
}

TEST(WrongInput, ASceneThatMuJoCoRejectsIsShownWithItsMessageAndLine) {
  const ScratchFolder folder;
  folder.write("scene.xml", "<mujoco>\n  <worldbody>\n    <geom type=\"cylindre\" size=\"1 1\"/>\n  </worldbody>\n</mujoco>\n");
  const auto file = folder.write("scene.toml",
                                 "[deployment]\nname = \"scene\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"mujoco\"\n"
                                 "[sim]\nscene = \"scene.xml\"\n");
  const std::string output = run_mrroc({"run", file.string()}, kSystem);
  expect_text(output, "process sim died");
  expect_text(output, "scene.xml");
  expect_text(output, "line 3");
  EXPECT_EQ(output.find("running"), std::string::npos) << output;
}

TEST(WrongInput, ADomainInUseIsSaid) {
  const ScratchFolder folder;
  const auto file = folder.write("domain.toml", "[deployment]\nname = \"domain\"\nclock = \"paced\"\ndomain = 117\n"
                                                "[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n"
                                                "program = \"" MRROC_BINARY_DIR "/bin/press_ecp\"\n");
  MrrocRun first({"run", "tasks/press/press.toml", "--clock", "paced"});
  ASSERT_TRUE(first.wait_for_output("running"));
  run_mrroc({"run", "tasks/press_replay/press_replay.toml", "--quiet"}, 0);  // another domain: both run
  const auto busy = folder.write("busy.toml", "[deployment]\nname = \"busy\"\ndomain = 1\n"
                                              "[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n");
  expect_text(run_mrroc({"run", busy.string()}, kUsage), "DDS domain 1 is in use");
}

TEST(WrongInput, ATraceThatCannotBeWrittenIsSaid) {
  expect_text(run_mrroc({"run", "tasks/press/press.toml", "--trace", "/no/such/folder/trace"}, kUsage),
              "/no/such/folder/trace");
}

TEST(WrongInput, ASensorThatTheDeploymentDoesNotHave) {
  const std::string output = run_faulty("sensor", kTaskFailed);
  expect_text(output, "the deployment has no sensor 'ghost', it has: none");
}

TEST(WrongInput, ARobotOfAnotherTypeThanTheTaskExpects) {
  const ScratchFolder folder;
  const auto file = folder.write("names.toml", "[deployment]\nname = \"names\"\n[mp]\nprogram = \"press_mp\"\n"
                                               "[robots.other]\ntype = \"irb6\"\nhardware = \"loopback\"\n");
  expect_text(run_mrroc({"run", file.string()}, kSystem), "the deployment has no robot 'arm', it has: other");
}

TEST(WrongInput, APoseOutOfTheWorkspace) {
  expect_text(run_faulty("pose", kTaskFailed), "the pose is out of the workspace");
  expect_text(run_faulty("commanded_pose", kTaskFailed), "the pose is out of the workspace");
}

TEST(WrongInput, NaNInACommand) { expect_text(run_faulty("nan", kTaskFailed), "not finite"); }

TEST(WrongInput, MotionStepsAndReplyStepOutOfRange) {
  expect_text(run_faulty("steps", kTaskFailed), "motion_steps N is out of range");
  expect_text(run_faulty("reply", kTaskFailed), "reply_step v is out of range");
}

TEST(WrongInput, ANonFatalErrorIsTheTasksToCatch) { run_faulty("caught", 0); }

TEST(WrongInput, ATaskThatCrashesIsNamed) {
  expect_text(run_faulty("crash", kSystem), "process arm died: signal 6 (Aborted)");
}

}  // namespace
}  // namespace mrroc::test
