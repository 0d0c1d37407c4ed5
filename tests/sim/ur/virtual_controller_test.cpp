#include "sim/ur/virtual_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace mrroc::sim::ur::virtual_controller_test {
namespace {

using mrroc::ur::rtde::FieldType;
using mrroc::ur::rtde::Value;

struct Controller : VirtualController {
  explicit Controller(bool powered = false)
      : VirtualController({.powered = powered}, std::make_unique<ExactJoints>(Six{1, 2, 3, 4, 5, 6})) {}

  bool step_until(auto condition) {
    for (int i = 0; i < 10000; ++i) {
      if (condition()) return true;
      step();
    }
    return false;
  }

  template <class T>
  T value(const std::string& name) const {
    return std::get<T>((*output(name))());
  }

  void write(const std::string& name, const Value& value) { input(name)->set(value); }
};

TEST(VirtualController, PowersUpInItsOrder) {
  Controller controller;
  EXPECT_EQ(controller.robot_mode(), RobotMode::power_off);
  EXPECT_EQ(controller.dashboard("brake release"), "Brake releasing");
  for (int i = 0; i < 200; ++i) controller.step();
  EXPECT_EQ(controller.robot_mode(), RobotMode::power_off) << "brakes need power";
  EXPECT_EQ(controller.dashboard("power on"), "Powering on");
  EXPECT_TRUE(controller.step_until([&] { return controller.robot_mode() == RobotMode::power_on; }));
  EXPECT_TRUE(controller.step_until([&] { return controller.robot_mode() == RobotMode::idle; }));
  EXPECT_EQ(controller.robot_status(), 1u);
  EXPECT_EQ(controller.dashboard("brake release"), "Brake releasing");
  EXPECT_TRUE(controller.step_until([&] { return controller.robot_mode() == RobotMode::running; }));
  EXPECT_EQ(controller.value<std::int32_t>("robot_mode"), 7);
}

TEST(VirtualController, AProtectiveStopIsHeldForItsTime) {
  Controller controller(true);
  ASSERT_TRUE(controller.start_program("def a():\nend\n"));
  controller.protective_stop();
  EXPECT_EQ(controller.safety_mode(), SafetyMode::protective_stop);
  EXPECT_EQ(controller.runtime(), RuntimeState::stopped);
  EXPECT_EQ(controller.safety_status() & 1u << 2, 1u << 2);
  const double begin = controller.time();
  EXPECT_TRUE(controller.step_until(
      [&] { return controller.dashboard("unlock protective stop") == "Protective stop releasing"; }));
  EXPECT_NEAR(controller.time() - begin, 5, 0.01);
  EXPECT_EQ(controller.safety_mode(), SafetyMode::normal);
  EXPECT_EQ(controller.robot_mode(), RobotMode::running);
}

TEST(VirtualController, AnEmergencyStopTakesThePower) {
  Controller controller(true);
  controller.emergency_stop(true);
  EXPECT_EQ(controller.robot_mode(), RobotMode::power_off);
  controller.dashboard("power on");
  for (int i = 0; i < 200; ++i) controller.step();
  EXPECT_EQ(controller.robot_mode(), RobotMode::power_off);
  controller.emergency_stop(false);
  controller.dashboard("power on");
  EXPECT_TRUE(controller.step_until([&] { return controller.robot_mode() == RobotMode::idle; }));
}

TEST(VirtualController, ProgramsNeedPowerAndRemoteControl) {
  Controller controller;
  EXPECT_FALSE(controller.start_program("def a():\nend\n"));
  Controller powered(true);
  EXPECT_FALSE(powered.start_program("no program"));
  powered.set_remote_control(false);
  EXPECT_FALSE(powered.start_program("def a():\nend\n"));
  EXPECT_EQ(powered.dashboard("is in remote control"), "false");
  powered.set_remote_control(true);
  EXPECT_TRUE(powered.start_program("def a():\nend\n"));
  EXPECT_EQ(powered.dashboard("programState"), "PLAYING a");
  EXPECT_EQ(powered.dashboard("running"), "Program running: true");
  EXPECT_EQ(powered.dashboard("stop"), "Stopped");
  EXPECT_EQ(powered.dashboard("running"), "Program running: false");
}

TEST(VirtualController, OutputsAreWrittenUnderTheirMask) {
  Controller controller;
  controller.write("standard_digital_output_mask", std::uint8_t{0x0c});
  controller.write("standard_digital_output", std::uint8_t{0xff});
  EXPECT_EQ(controller.digital_outputs(), 0x0cu);
  controller.write("standard_digital_output", std::uint8_t{0});
  EXPECT_EQ(controller.digital_outputs(), 0x0cu) << "a mask is of one package";
  controller.write("configurable_digital_output_mask", std::uint8_t{1});
  controller.write("configurable_digital_output", std::uint8_t{1});
  controller.write("tool_digital_output_mask", std::uint8_t{2});
  controller.write("tool_digital_output", std::uint8_t{2});
  EXPECT_EQ(controller.digital_outputs(), 0x2010cu);
  EXPECT_EQ(controller.value<std::uint64_t>("actual_digital_output_bits"), 0x2010cu);
}

TEST(VirtualController, HasTheFieldsOfTheGuide) {
  const Controller controller;
  EXPECT_EQ(controller.output("no_such_field"), nullptr);
  EXPECT_EQ(controller.input("actual_q"), nullptr);
  EXPECT_EQ(controller.output("output_int_register_48"), nullptr);
  EXPECT_EQ(controller.value<mrroc::ur::rtde::Vector6d>("actual_q"), (Six{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(controller.input("input_int_register_47")->type, FieldType::int32);
  EXPECT_EQ(controller.input("speed_slider_mask")->type, FieldType::uint32);
}

/// The figures of the UR5e's data sheet at joint angles of zero.
TEST(VirtualController, TheToolIsWhereAUr5eHasIt) {
  VirtualController controller({.powered = true}, std::make_unique<ExactJoints>(Six{}));
  const Six pose = controller.tool_pose();
  EXPECT_NEAR(pose[0], -0.425 - 0.3922, 1e-9);
  EXPECT_NEAR(pose[1], -0.1333 - 0.0996, 1e-9);
  EXPECT_NEAR(pose[2], 0.1625 - 0.0997, 1e-9);
  EXPECT_NEAR(std::hypot(pose[3], pose[4], pose[5]), std::numbers::pi / 2, 1e-9);
  ASSERT_TRUE(controller.start_program("set_tcp(p[0, 0, 0.1, 0, 0, 0])"));
  EXPECT_NEAR(controller.tool_pose()[1], pose[1] - 0.1, 1e-9);
  EXPECT_EQ(controller.tool_offset(), (Six{0, 0, 0.1, 0, 0, 0}));
}

TEST(VirtualController, TheWrenchIsThatOfTheEnvironmentInTheBaseFrame) {
  auto joints = std::make_unique<ExactJoints>(Six{});
  joints->set_load((Wrench() << 0, 5, 0, 0, 0, 0).finished());  // along y of the flange, which is z of the base
  VirtualController controller({.powered = true}, std::move(joints));
  EXPECT_NEAR(controller.tool_force()[2], 5, 1e-9);
  EXPECT_NEAR(controller.flange_load()[1], 5, 1e-9);
  ASSERT_TRUE(controller.start_program("set_payload(0.5, [0, 0, 0.1])"));
  EXPECT_NEAR(controller.tool_force()[2], 5 + 0.5 * 9.81, 1e-9) << "a payload that is missing";
  EXPECT_NEAR(controller.flange_load()[1], 5, 1e-9);
}

/// Terminals with things wired to them.
struct WiredJoints : ExactJoints {
  WiredJoints() : ExactJoints(Six{}) { wired.analog = {1, 2, 3, 4}; }
  std::optional<ControllerIo> inputs() const override { return wired; }
  void set_outputs(const ControllerIo& outputs) override { received = outputs; }
  ControllerIo wired, received;
};

TEST(VirtualController, ExchangesItsTerminalsWithThePlant) {
  auto plant = std::make_unique<WiredJoints>();
  WiredJoints& wired = *plant;
  VirtualController controller({.powered = true}, std::move(plant));
  wired.wired.digital = 0x8001;
  controller.step();
  EXPECT_EQ(std::get<std::uint64_t>((*controller.output("actual_digital_input_bits"))()), 0x8001u);
  EXPECT_EQ(std::get<double>((*controller.output("standard_analog_input1"))()), 2);
  EXPECT_EQ(std::get<double>((*controller.output("tool_analog_input0"))()), 3);
  ASSERT_TRUE(controller.start_program("set_digital_out(3, True)"));
  ASSERT_TRUE(controller.start_program("set_analog_out(1, 0.5)"));
  controller.step();
  EXPECT_EQ(wired.received.digital, 8u);
  EXPECT_EQ(wired.received.analog[1], 5);
}

TEST(VirtualController, ARestartBootsWithoutPower) {
  Controller controller(true);
  controller.step();
  controller.restart();
  EXPECT_EQ(controller.robot_mode(), RobotMode::booting);
  EXPECT_EQ(controller.time(), 0);
  EXPECT_TRUE(controller.step_until([&] { return controller.robot_mode() == RobotMode::power_off; }));
  EXPECT_EQ(controller.position(), (Six{1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace mrroc::sim::ur::virtual_controller_test
