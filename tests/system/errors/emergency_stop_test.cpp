// The emergency stop in a user's task: pressed by an event, by the operator's typed word, by an input.
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <string>
#include <thread>

#include "system/keyboard.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::emergency_stop_test {
namespace {

std::string deployment(const std::string& name, const std::string& clock, const std::string& rest) {
  return "[deployment]\nname = \"" + name + "\"\nclock = \"" + clock +
         "\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR
         "/tests/emergency_stop_ecp\"\n" +
         rest;
}

std::string event(int tick, const std::string& command) {
  return "[[events]]\ntick = " + std::to_string(tick) + "\ncommand = \"" + command + "\"\n";
}

void expect_stopped_and_went_on(const std::string& output) {
  EXPECT_NE(output.find("stopped: hardware error: the emergency stop is pressed or not reset: at tick"),
            std::string::npos)
      << output;
  EXPECT_NE(output.find("| went on"), std::string::npos) << output;
}

TEST(EmergencyStop, OneEventPressesItAnotherResetsIt) {
  const ScratchFolder folder;
  const auto file =
      folder.write("stop.toml", deployment("event", "lockstep", event(1500, "estop") + event(3000, "reset")));
  std::set<std::string> hashes;
  for (int run = 0; run < 3; ++run) {
    const auto trace = folder.path() / "trace.mcap";
    const std::string output = run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, 0);
    expect_stopped_and_went_on(output);
    EXPECT_NE(output.find("at tick 1500"), std::string::npos) << "every servo checks it at every tick: " << output;
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST(EmergencyStop, TaskNeverContinuesWithoutAReset) {
  const ScratchFolder folder;
  const auto file = folder.write("stop.toml", deployment("event", "lockstep", event(1500, "estop")));
  const std::string output = run_mrroc({"run", file.string(), "--quiet"}, 1);
  EXPECT_NE(output.find("the emergency stop was not reset"), std::string::npos) << output;
  EXPECT_EQ(output.find("went on"), std::string::npos) << output;
}

TEST(EmergencyStop, OperatorTypesIt) {
  for (const std::string clock : {"paced", "real"}) {
    const ScratchFolder folder;
    Keyboard keyboard;
    MrrocRun run({"run", folder.write("stop.toml", deployment("typed", clock, "")).string(), "--quiet"});
    ASSERT_TRUE(run.wait_for_output("moves")) << run.err();
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    keyboard.type("estop\n");
    ASSERT_TRUE(run.wait_for_output("stopped: ")) << run.err();
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    EXPECT_FALSE(run.has_ended()) << run.out();
    keyboard.type("reset\n");
    EXPECT_EQ(run.wait(), 0) << run.err();
    expect_stopped_and_went_on(run.out());
  }
}

TEST(EmergencyStop, InputPressesItAndTheOperatorResetsIt) {
  const ScratchFolder folder;
  const auto file =
      folder.write("input.toml", deployment("input", "lockstep", "emergency_stop = 3\n" + event(4000, "reset")));
  expect_stopped_and_went_on(run_mrroc({"run", file.string(), "--quiet"}, 0));
}

TEST(EmergencyStop, InputThatIsNotInTheSceneIsNamedBeforeAnyMotion) {
  const ScratchFolder folder;
  std::string text = deployment("unwired", "lockstep",
                                "emergency_stop = 3\n[sim]\nscene = \"" MRROC_SOURCE_DIR "/robots/irb6/demo.xml\"\n");
  text.replace(text.find("loopback"), std::string("loopback").size(), "mujoco");
  const std::string output = run_mrroc({"run", folder.write("unwired.toml", text).string()}, 2);
  EXPECT_NE(output.find("unwired.toml: robots.arm.emergency_stop: input_3 is not in the scene, so that it would be "
                        "pressed permanently, expected a sensor 'arm/input_3'"),
            std::string::npos)
      << output;
  EXPECT_EQ(output.find("moves"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::emergency_stop_test
