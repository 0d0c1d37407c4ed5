// Injected faults of CiA 401 nodes on the bus of a robot, as `mrroc run --inject` makes them, in lockstep.
#include "mrroc/testing.hpp"
#include "system/io_on_bus.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::can_io_faults_test {
namespace {

/// A room with a released emergency stop at input 3: its contact is closed.
constexpr const char* kReleasedButton = R"(<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <body name="button" pos="1 1 1">
      <joint name="button" type="slide" axis="1 0 0" ref="1" damping="10"/>
      <geom size="0.02" mass="0.2" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
  <sensor><jointpos name="arm/input_3" joint="button"/></sensor>
</mujoco>)";

/// A kind of fault of a node, and the text of its error.
struct NodeFault {
  const char* action;
  const char* error;
};

class CanIoFaults : public task_test::DeploymentTest, public testing::WithParamInterface<NodeFault> {
 protected:
  /// `press` on a bus with the node 40.
  task_test::DeploymentRun press() {
    std::string text = deployment_of("press", {"press.xml"});
    put_on_bus(text, folder_, "arm", io_of_16(folder_));
    return deployment(folder_.write("press.toml", text));
  }
  /// An arm on a bus with the node 40, whose task recovers after each stop; `more`: lines of its section.
  task_test::DeploymentRun recovering(const std::string& more = "") {
    folder_.write("room.xml", kReleasedButton);
    std::string text =
        "[deployment]\nname = \"can\"\nclock = \"lockstep\"\n[robots.arm]\ntype = \"irb6\"\n"
        "program = \"" MRROC_BINARY_DIR "/tests/bus_fault_ecp\"\nhardware = \"mujoco\"\nposition = [0.0, 0.0, 0.7]\n" +
        more + "\n[sim]\nscene = \"room.xml\"\n";
    put_on_bus(text, folder_, "arm", io_of_16(folder_));
    return deployment(folder_.write("recovering.toml", text));
  }
  ScratchFolder folder_;
};

TEST_P(CanIoFaults, StopTheArmWithinItsLimits) {
  const std::string fault = GetParam().action + std::string{" io:arm node 40 at step 120"};
  const auto run = press().inject(fault).run();
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.error.find("an I/O node fails"), std::string::npos) << run.output;
  EXPECT_NE(run.error.find(GetParam().error), std::string::npos) << run.output;
  expect_safe(run);
  const Tick injected = run.injected.at(fault);
  const task_test::Motion& arm = run.motion.at("arm");
  EXPECT_GT(arm.velocities[injected].cwiseAbs().maxCoeff(), 0.01) << "it must be in motion";
  EXPECT_GT(arm.standstill(), injected);
}

TEST_P(CanIoFaults, LetTheArmRecoverWhenTheyHaveEnded) {
  const std::string fault = GetParam().action + std::string{" io:arm node 40 at tick 1000 for 600 ticks"};
  const auto run = recovering().inject(fault).run();
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find(GetParam().error), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("| recovered"), std::string::npos) << run.output;
  expect_safe(run);
}

INSTANTIATE_TEST_SUITE_P(Can, CanIoFaults,
                         testing::Values(NodeFault{"silence", "node 40: no TPDO 1"},
                                         NodeFault{"restart", "node 40 has restarted"},
                                         NodeFault{"hush", "node 40: the last heartbeat is"},
                                         NodeFault{"fault", "node 40: error code 5000h"}),
                         [](const auto& each) { return std::string{each.param.action}; });

TEST_F(CanIoFaults, SameFaultGivesTheSameRun) {
  const char* const fault = "silence io:arm node 40 at step 120";
  const auto first = press().inject(fault).run(), second = press().inject(fault).run();
  EXPECT_EQ(first.error, second.error);
  EXPECT_EQ(first.injected, second.injected);
  ASSERT_EQ(first.steps.size(), second.steps.size());
  for (std::size_t i = 0; i < first.steps.size(); ++i) EXPECT_EQ(first.steps[i].json, second.steps[i].json);
}

/// As a wire that breaks: nothing but the operator's reset ends it, so the task does not recover.
TEST_F(CanIoFaults, AnInputOfTheEmergencyStopThatSticksStopsTheArm) {
  const auto run = recovering("emergency_stop = 3").inject("stick io:arm input 3 to 0 at tick 1000").run();
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("| stopped: hardware error: the emergency stop is pressed"), std::string::npos)
      << run.output;
  EXPECT_GT(run.motion.at("arm").velocities[990].cwiseAbs().maxCoeff(), 0.01) << "it must be in motion";
  EXPECT_GT(run.motion.at("arm").standstill(), 1000U);
  expect_safe(run);
}

TEST_F(CanIoFaults, RefusesANodeThatTheRobotDoesNotHave) {
  const auto run = press().inject("silence io:arm node 41 at tick 1000").run();
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("no I/O node 41, expected one of 40"), std::string::npos) << run.output;
}

TEST_F(CanIoFaults, RefusesANodeOfARobotThatIsNotOnABus) {
  const auto run = deployment(kTasks / "press/press.toml").inject("silence io:arm node 40 at tick 1000").run();
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_NE(run.output.find("the deployment has no process 'arm_drives'"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace mrroc::test::can_io_faults_test
