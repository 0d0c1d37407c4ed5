#include "drivers/ur/ur_fault.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrroc::ur::ur_fault_test {
namespace {

using testing::HasSubstr;

RobotState ready() {
  RobotState state;
  state.robot_mode = RobotMode::running;
  state.safety_mode = SafetyMode::normal;
  state.joint_mode.fill(static_cast<std::int32_t>(JointMode::running));
  state.runtime = RuntimeState::playing;
  state.robot_status = 3;
  state.script = ScriptState::following_position;
  state.script_program = 7;
  return state;
}

ErrorCode safety(SafetyMode mode) {
  RobotState state = ready();
  state.safety_mode = mode;
  return code_of(safety_fault(state));
}

TEST(UrFault, AReadyRobotHasNone) {
  EXPECT_EQ(code_of(safety_fault(ready())), ErrorCode::none);
  EXPECT_EQ(code_of(following_fault(ready(), 7)), ErrorCode::none);
  EXPECT_TRUE(describe(UrFault{}).empty());
}

TEST(UrFault, SafetyModesHaveTheirCodes) {
  EXPECT_EQ(safety(SafetyMode::reduced), ErrorCode::none);
  EXPECT_EQ(safety(SafetyMode::protective_stop), ErrorCode::drive_fault);
  EXPECT_EQ(safety(SafetyMode::robot_emergency_stop), ErrorCode::emergency_stop);
  EXPECT_EQ(safety(SafetyMode::system_emergency_stop), ErrorCode::emergency_stop);
  for (const SafetyMode mode :
       {SafetyMode::safeguard_stop, SafetyMode::automatic_safeguard_stop, SafetyMode::three_position_stop})
    EXPECT_EQ(safety(mode), ErrorCode::drive_not_ready);
  for (const SafetyMode mode :
       {SafetyMode::violation, SafetyMode::fault, SafetyMode::recovery, SafetyMode::validate_joint_id})
    EXPECT_EQ(safety(mode), ErrorCode::drive_fault);
}

TEST(UrFault, AJointsFaultNamesItsAxisAndMode) {
  for (const JointMode mode : {JointMode::fault, JointMode::violation, JointMode::not_responding}) {
    RobotState state = ready();
    state.joint_mode[2] = static_cast<std::int32_t>(mode);
    const UrFault fault = safety_fault(state);
    EXPECT_EQ(code_of(fault), ErrorCode::drive_fault);
    EXPECT_EQ(axis_of(fault), 2);
    EXPECT_THAT(std::string(describe(fault).view()), HasSubstr(std::string(name_of(mode))));
  }
}

TEST(UrFault, AFollowingRobotNeedsPowerAndItsProgram) {
  RobotState state = ready();
  state.robot_mode = RobotMode::idle;
  EXPECT_TRUE(std::holds_alternative<PowerOff>(following_fault(state, 7)));
  state = ready();
  state.runtime = RuntimeState::paused;
  EXPECT_TRUE(std::holds_alternative<ProgramStopped>(following_fault(state, 7)));
  state = ready();
  EXPECT_TRUE(std::holds_alternative<ProgramStopped>(following_fault(state, 8)));
  state.script = ScriptState::ended;
  state.runtime = RuntimeState::stopped;
  EXPECT_TRUE(std::holds_alternative<SetPointsMissing>(following_fault(state, 7)));
}

TEST(UrFault, EveryFaultHasACodeAndAText) {
  const UrFault faults[] = {SilentController{12, {}},
                            ProtectiveStop{},
                            EmergencyStop{},
                            SafeguardStop{},
                            SafetyFault{},
                            JointFault{},
                            PowerOff{},
                            NotInRemoteControl{},
                            ProgramStopped{},
                            SetPointsMissing{},
                            StartFailed{edp::driver_text("why")}};
  EXPECT_EQ(std::size(faults) + 1, std::variant_size_v<UrFault>);
  for (const UrFault& fault : faults) {
    EXPECT_NE(code_of(fault), ErrorCode::none);
    EXPECT_FALSE(describe(fault).empty()) << fault.index();
  }
}

}  // namespace
}  // namespace mrroc::ur::ur_fault_test
