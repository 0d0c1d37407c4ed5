#include "sim/ur/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "drivers/ur/command.hpp"
#include "drivers/ur/control_script.hpp"
#include "drivers/ur/robot_state.hpp"

namespace mrroc::sim::ur::program_test {
namespace {

using mrroc::ur::ControlMode;
using mrroc::ur::ScriptState;

constexpr std::size_t kRegister = 24;
constexpr int kWatchdog = 50;  // periods

std::string control_text() {
  mrroc::ur::UrOptions options;
  options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
  return mrroc::ur::control_program(mrroc::ur::read_control_script(options), options, 500, 7);
}

/// A program on an arm, with the registers that a client writes.
struct Running {
  explicit Running(const std::string& text) : program(make_program(text)) {}

  bool step(ControlMode mode, const Six& position = {}, const Six& velocity = {}) {
    ++registers.integer_inputs[kRegister];
    registers.integer_inputs[kRegister + 1] = static_cast<std::int32_t>(mode);
    for (std::size_t i = 0; i < 6; ++i) {
      registers.real_inputs[kRegister + i] = position[i];
      registers.real_inputs[kRegister + 6 + i] = velocity[i];
    }
    return step();
  }

  bool step() {
    ProgramSurroundings around{registers, motion, joints, 0.002};
    const bool runs = program->step(around);
    joints.step(motion.targets(joints), 0.002);
    return runs;
  }

  ScriptState state() const { return static_cast<ScriptState>(registers.integer_outputs[kRegister]); }

  std::unique_ptr<Program> program;
  Registers registers;
  ArmMotion motion{0.002};
  ExactJoints joints{Six{}};
};

TEST(ControlProgram, ReportsItsNumberAndItsSetPoints) {
  Running running(control_text());
  EXPECT_EQ(running.program->name(), "mrroc_control");
  ASSERT_TRUE(running.step(ControlMode::hold));
  EXPECT_EQ(running.state(), ScriptState::holding);
  EXPECT_EQ(running.registers.integer_outputs[kRegister + 2], 7);
  ASSERT_TRUE(running.step(ControlMode::hold));
  EXPECT_EQ(running.registers.integer_outputs[kRegister + 1], running.registers.integer_inputs[kRegister]);
}

TEST(ControlProgram, FollowsBothInterfacesAndStops) {
  Running running(control_text());
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(running.step(ControlMode::position, Six{0.1}));
  EXPECT_EQ(running.state(), ScriptState::following_position);
  EXPECT_NEAR(running.joints.position()[0], 0.1, 1e-6);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(running.step(ControlMode::velocity, {}, Six{0.5}));
  EXPECT_EQ(running.state(), ScriptState::following_velocity);
  EXPECT_NEAR(running.joints.velocity()[0], 0.5, 1e-3);
  ASSERT_TRUE(running.step(ControlMode::hold));
  EXPECT_EQ(running.state(), ScriptState::stopping);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(running.step(ControlMode::hold));
  EXPECT_EQ(running.state(), ScriptState::holding);
  EXPECT_NEAR(running.joints.velocity()[0], 0, 1e-3);
}

TEST(ControlProgram, WithoutNewSetPointsItStopsAndEnds) {
  Running running(control_text());
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(running.step(ControlMode::velocity, {}, Six{0.5}));
  int periods = 0;
  while (running.state() == ScriptState::following_velocity) {
    ASSERT_TRUE(running.step());
    ASSERT_LE(++periods, kWatchdog + 1);
  }
  EXPECT_EQ(periods, kWatchdog + 1);
  for (periods = 0; running.step(); ++periods) ASSERT_LT(periods, 1000);
  EXPECT_EQ(running.state(), ScriptState::ended);
  EXPECT_NEAR(running.joints.velocity()[0], 0, 1e-3);
}

TEST(ControlProgram, TheWatchdogAlsoEndsAProgramThatHolds) {
  Running running(control_text());
  ASSERT_TRUE(running.step(ControlMode::hold));
  int periods = 0;
  while (running.step()) ASSERT_LT(++periods, 1000);
  EXPECT_EQ(running.state(), ScriptState::ended);
}

TEST(OtherProgram, RunsForAWhile) {
  const auto program = make_program("def some_name():\n  textmsg(\"a\")\nend\n");
  EXPECT_EQ(program->name(), "some_name");
  Running running("def other():\nend\n");
  EXPECT_TRUE(running.step());
  int steps = 0;
  while (running.step()) ASSERT_LT(++steps, 1000);
}

TEST(SingleCommand, MovejMovesWithItsSpeed) {
  Running running("movej([0.1,0,-0.2,0,0,0], a=2, v=0.5, r=0)");
  EXPECT_EQ(running.program->name(), "movej");
  double fastest = 0;
  for (int steps = 0; running.step(); ++steps) {
    ASSERT_LT(steps, 10000);
    fastest = std::max(fastest, std::abs(running.joints.velocity()[2]));
  }
  EXPECT_NEAR(fastest, 0.5, 0.1);
  EXPECT_NEAR(running.joints.position()[0], 0.1, 1e-3);
  EXPECT_NEAR(running.joints.position()[2], -0.2, 1e-3);
}

TEST(MakeProgram, RejectsTextsThatAreNoPrograms) {
  EXPECT_THROW(make_program(""), std::invalid_argument);
  for (const char* line :
       {"movej([1,2,3])", "stopj()", "stopj(0)", "# movej", "a = 1", "movej([0,0,0,0,0,0], a=1, v=0)", "stopj(1e999)"})
    EXPECT_THROW(make_program(line), std::invalid_argument) << line;
  EXPECT_THROW(make_program("def mrroc_control():\nend\n"), std::invalid_argument);
  std::string wrong = control_text();
  wrong.replace(wrong.find("read_input_integer_register(24)"), 31, "read_input_integer_register(47)");
  EXPECT_THROW(make_program(wrong), std::invalid_argument);
}

TEST(MakeProgram, RejectsNamesAndNumbersWithoutEnd) {
  constexpr std::size_t kMany = 1 << 20;
  EXPECT_THROW(make_program("def " + std::string(kMany, 'a') + "():\nend\n"), std::invalid_argument);
  EXPECT_THROW(make_program("def" + std::string(kMany, ' ') + "a():\nend\n"), std::invalid_argument);
  EXPECT_THROW(make_program("def a" + std::string(kMany, ' ') + "():\nend\n"), std::invalid_argument);
  for (const std::string call :
       {"read_input_integer_register(", "read_input_float_register(", "silent > ", "stopj(", "speedj(velocities(), "}) {
    std::string wrong = control_text();
    for (std::size_t at = wrong.find(call); at != std::string::npos; at = wrong.find(call, at + kMany))
      wrong.insert(at + call.size(), kMany, '1');
    EXPECT_THROW(make_program(wrong), std::invalid_argument) << call;
  }
}

}  // namespace
}  // namespace mrroc::sim::ur::program_test
