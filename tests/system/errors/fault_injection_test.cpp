#include <algorithm>

#include "mrroc/testing.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::task_test::fault_injection_test {
namespace {

/// tasks/press with faults, as in a user's test.
class FaultInjection : public DeploymentTest {
 protected:
  static DeploymentRun press() { return deployment("../../tasks/press/press.toml"); }
};

TEST_F(FaultInjection, EcpDeathAtAStepEndsTheRunThereAndTheArmBrakes) {
  const RunResult run = press().inject("kill ecp:arm at step 120").run();
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_NE(run.error.find("process arm died: signal 9 (Killed)"), std::string::npos) << run.output;
  EXPECT_LE(run.steps_of("arm").size(), 120U);  // what it had not written yet is lost with it
  expect_safe(run);
  const Tick killed = run.injected.at("kill ecp:arm at step 120");
  const Motion& arm = run.motion.at("arm");
  EXPECT_GT(arm.velocities[killed].cwiseAbs().maxCoeff(), 0.01) << "it must be in motion";
  EXPECT_GT(arm.standstill(), killed);
}

/// Up to the last step that both have in their recordings: the time until the runner detects a task's end, and until
/// all processes have left, is wall time.
bool same_motion(const RunResult& one, const RunResult& other) {
  if (one.steps.empty() || other.steps.empty()) return false;
  const Motion &first = one.motion.at("arm"), &second = other.motion.at("arm");
  const std::size_t length =
      std::min({one.steps.back().tick, other.steps.back().tick, first.ticks.size(), second.ticks.size()});
  return length > 0 && std::equal(first.positions.begin(), first.positions.begin() + static_cast<long>(length),
                                  second.positions.begin());
}

TEST_F(FaultInjection, SameFaultGivesTheSameRun) {
  for (const char* fault : {"kill ecp:arm at step 120", "halt edp:arm at tick 2500", "kill mp at tick 1234",
                            "disconnect edp:arm axis 2 at step 100", "delay ecp:arm by 40 at step 50 for 100 ticks"}) {
    const RunResult first = press().inject(fault).run(), second = press().inject(fault).run();
    EXPECT_EQ(first.exit_code, second.exit_code) << fault;
    EXPECT_EQ(first.error, second.error) << fault;
    EXPECT_EQ(first.injected, second.injected) << fault;
    const double tolerance = std::string_view{fault}.starts_with("disconnect") ? kDisobedience : kOvershoot;
    expect_safe(first, tolerance), expect_safe(second, tolerance);
    EXPECT_TRUE(same_motion(first, second)) << fault;
  }
}

/// A system error while the robot is not executing its task.
class Halted : public FaultInjection {
 protected:
  /// An IRb-6 in the room of its demo, with another task; `more`: lines of its section.
  DeploymentRun arm(const std::string& program, const std::string& more = "") {
    const std::string scene = MRROC_SOURCE_DIR "/robots/irb6/demo.xml";
    return deployment(folder_.write(
        "halted.toml",
        "[deployment]\nname = \"halted\"\nclock = \"lockstep\"\n[robots.arm]\ntype = "
        "\"irb6\"\nhardware = \"mujoco\"\nposition = [0.0, 0.0, 0.7]\nprogram = \"" MRROC_BINARY_DIR "/tests/" +
            program + "\"\n" + more + "[sim]\nscene = \"" + scene + "\"\n"));
  }

  test::ScratchFolder folder_;
};

TEST_F(Halted, FromAFaultTheRobotStaysWhereItIs) {
  const RunResult run =
      arm("bus_fault_ecp").inject("fault edp:arm at tick 1500 for 100 ticks").inject("kill mp at tick 1530").run();
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_NE(run.error.find("process mp died: signal 9 (Killed)"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("stopped: hardware error: "), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("recovered"), std::string::npos) << run.output;
  expect_safe(run);
}

TEST_F(Halted, WithoutItsPositionsTheRobotStops) {
  const std::string killed = "kill ecp:arm at tick 1800";
  const RunResult run = arm("synchronise_ecp", "synchronised = false\n").inject(killed).run();
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_NE(run.error.find("process arm died: signal 9 (Killed)"), std::string::npos) << run.output;
  expect_safe(run);
  const Motion& arm = run.motion.at("arm");
  EXPECT_GT(arm.velocities[run.injected.at(killed)].cwiseAbs().maxCoeff(), 1e-3) << "it must be in motion";
  EXPECT_GT(arm.standstill(), run.injected.at(killed));
}

TEST_F(FaultInjection, ProcessThatLeavesTooEarlyIsNamed) {
  for (const auto& [fault, name] : std::map<std::string, std::string>{{"end mp at tick 1500", "mp"},
                                                                      {"end ecp:arm at tick 1500", "arm"},
                                                                      {"end edp:arm at tick 1500", "arm_edp"},
                                                                      {"end vsp:wrist at tick 1500", "wrist"}}) {
    const RunResult run = press().inject(fault).run();
    EXPECT_EQ(run.exit_code, 4) << run.output;
    EXPECT_NE(run.error.find("process " + name + " died: exit code "), std::string::npos) << run.output;
    expect_safe(run);
  }
}

TEST_F(FaultInjection, CurrentThatStaysAtItsMaximumStopsTheArm) {
  const RunResult run = press().inject("overload edp:arm axis 2 at tick 1000").run();
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.error.find("hardware error: a drive's current has been at its limit for too long: axis 2 (lower_arm), "
                           "tick 2000"),
            std::string::npos)
      << run.output;
  expect_safe(run);
}

TEST_F(FaultInjection, RunawayAxisIsStopped) {
  const RunResult run = press().inject("runaway edp:arm axis 2 at tick 2500").run();
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.error.find("hardware error: a joint is faster than its limit"), std::string::npos) << run.output;
  expect_safe(run, kDisobedience);
  EXPECT_NE(run.motion.at("arm").limits_exceeded(), std::vector<std::string>{}) << "it must run away";
}

TEST_F(FaultInjection, DriveFaultIsAHardwareErrorOfItsTick) {
  const RunResult run = press().inject("fault edp:arm at tick 2500").run();
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.error.find("hardware error: a drive reports a fault: at tick 2500"), std::string::npos) << run.output;
  expect_safe(run);
  const auto endings = run.endings();
  EXPECT_TRUE(std::any_of(endings.begin(), endings.end(),
                          [](const Step& step) { return step.process == "arm" && step.ending == "hardware_error"; }));
}

TEST_F(FaultInjection, NanOfASensorIsAnErrorWhereItIsUsed) {
  const RunResult run = press().inject("nan vsp:wrist at tick 10").run();
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.error.find("the sensor hardware malfunctions"), std::string::npos) << run.output;
  expect_safe(run);
}

TEST_F(FaultInjection, TemporarilyLateCommandsAreCompensated) {
  const RunResult run = press().inject("delay ecp:arm by 40 at step 50 for 100 ticks").run();
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_safe(run);
}

TEST_F(FaultInjection, LostCommandStopsTheArmAndItsEcpMissesTheAnswer) {
  const RunResult run = press().inject("lose ecp:arm at step 100").run();
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_NE(run.error.find("a process is silent: no answer to a command that was lost"), std::string::npos)
      << run.output;
  expect_safe(run);
  EXPECT_LT(run.motion.at("arm").standstill(), run.injected.at("lose ecp:arm at step 100") + 500)
      << "the arm does not wait for its ECP";
}

TEST_F(FaultInjection, NothingIsInjectedWithoutAFault) {
  const RunResult run = press().run();
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(run.injected.empty());
  expect_safe(run);
}

TEST_F(FaultInjection, InvalidFaultIsRefusedBeforeAnythingIsStarted) {
  for (const auto& [fault, message] : std::map<std::string, std::string>{
           {"kill arm",
            "the fault \"kill arm\": 'arm', expected mp, sim, ecp:ROBOT, edp:ROBOT, drives:ROBOT or vsp:SENSOR"},
           {"kill ecp:leg at tick 1", "the deployment has no process 'leg', it has sim, arm_edp, wrist, gate, arm, mp"},
           {"kill sim at step 1 of leg", "the deployment has no process 'leg'"}}) {
    const RunResult run = press().inject(fault).run();
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_NE(run.output.find(message), std::string::npos) << run.output;
    EXPECT_TRUE(run.motion.empty());
  }
  const RunResult run = press().inject("nan edp:arm axis 7 at tick 1").run();
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("irb6 has 6 axes"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace mrroc::task_test::fault_injection_test
