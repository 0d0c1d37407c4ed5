#include "drivers/ur/ur_hardware.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "allocations.hpp"
#include "drivers/ur/ur_rig.hpp"

namespace mrroc::ur::ur_hardware_test {
namespace {

using testing::HasSubstr;

class InBothInterfaces : public testing::TestWithParam<Interface> {};

TEST_P(InBothInterfaces, FollowsSetPoints) {
  Rig rig(GetParam());
  EXPECT_TRUE(rig.input.synchronised);
  EXPECT_NEAR(rig.input.motors[1], -1.5 * kGear, 1e-9);
  ASSERT_TRUE(rig.start());
  const Six before = rig.joints();
  rig.rate << 20, -10, 0, 5, 0, -30;  // of the shafts, rad/s
  rig.ticks(250);
  rig.rate.setZero();
  const JointVector end = rig.set;
  EXPECT_TRUE(rig.tick_until([&] { return (rig.input.motors - end).cwiseAbs().maxCoeff() < 1e-2 * kGear; }));
  EXPECT_TRUE(rig.tick_until([&] { return (rig.input.motors - end).cwiseAbs().maxCoeff() < 1e-4 * kGear; }));
  EXPECT_TRUE(rig.healthy());
  const Six after = rig.joints();
  EXPECT_GT(after[0], before[0] + 0.05);
  EXPECT_LT(after[5], before[5] - 0.05);
  EXPECT_NEAR(after[2], before[2], 1e-3);
}

TEST_P(InBothInterfaces, DisabledItHoldsWithPowerOn) {
  Rig rig(GetParam());
  ASSERT_TRUE(rig.start());
  rig.rate[0] = 20;
  rig.ticks(50);
  rig.enable(false);
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->state().script == ScriptState::holding; }));
  const Six there = rig.joints();
  rig.ticks(50);
  EXPECT_NEAR(rig.joints()[0], there[0], 1e-3);
  EXPECT_EQ(rig.hardware->state().robot_mode, RobotMode::running);
  EXPECT_TRUE(rig.healthy());
  EXPECT_TRUE(rig.start());
}

TEST_P(InBothInterfaces, WithoutSetPointsTheControlScriptStopsTheRobot) {
  Rig rig(GetParam(), free_ports(), [](UrOptions& options) { options.watchdog = 0.05; });
  for (int attempt = 0; attempt < 5 && !rig.start(); ++attempt) rig.recover();
  ASSERT_TRUE(rig.healthy());
  rig.rate[0] = 20;
  rig.ticks(30);
  while (!rig.controller.ask([](VirtualController& c) { return c.program().empty(); })) std::this_thread::yield();
  EXPECT_NEAR(rig.controller.ask([](VirtualController& c) { return c.velocity(); })[0], 0, 1e-3);
  ASSERT_TRUE(rig.finds(ErrorCode::drive_not_ready));
  EXPECT_THAT(rig.text(), HasSubstr("received no set-points"));
}

INSTANTIATE_TEST_SUITE_P(UrHardware, InBothInterfaces, testing::Values(Interface::position, Interface::velocity));

TEST(UrHardware, SwitchesPowerOnAndReleasesBrakes) {
  Rig rig;
  EXPECT_EQ(rig.hardware->state().robot_mode, RobotMode::power_off);
  EXPECT_TRUE(rig.healthy()) << "an arm without power is no fault before it is enabled";
  ASSERT_TRUE(rig.start());
  EXPECT_EQ(rig.hardware->state().robot_mode, RobotMode::running);
  EXPECT_EQ(rig.controller.ask([](VirtualController& c) { return std::string(c.program()); }), "mrroc_control");
}

TEST(UrHardware, SetsPayloadToolVoltageAndSpeedSlider) {
  Rig rig(Interface::position, free_ports(), [](UrOptions& options) {
    options.payload_mass = 1.5;
    options.tool_voltage = 24;
    options.speed_slider = 0.5;
  });
  ASSERT_TRUE(rig.start());
  EXPECT_EQ(rig.controller.ask([](VirtualController& c) { return c.payload(); }), 1.5);
  EXPECT_EQ(rig.controller.ask([](VirtualController& c) { return c.tool_voltage(); }), 24);
  EXPECT_EQ(rig.controller.ask([](VirtualController& c) { return c.speed_slider(); }), 0.5);
}

TEST(UrHardware, ExchangesTheControllersTerminals) {
  Rig rig;
  rig.controller.servers.with([](VirtualController& c) { c.set_inputs(0x8001, 2.5, 7); });
  EXPECT_TRUE(rig.tick_until([&] { return rig.input.inputs.digital == 0x8001; }));
  EXPECT_EQ(rig.input.inputs.analog[0], 2.5);
  EXPECT_EQ(rig.input.inputs.analog[1], 7);
  EXPECT_EQ(rig.controller.ask([](VirtualController& c) { return c.digital_outputs(); }), 0u);
  ControllerIo outputs;
  outputs.set(3, true);
  outputs.set(12, true);
  outputs.analog = {5, 1};
  rig.hardware->set_outputs(outputs);  // the drives are off
  EXPECT_TRUE(rig.tick_until(
      [&] { return rig.controller.ask([](VirtualController& c) { return c.digital_outputs(); }) == 0x1008u; }));
  EXPECT_NEAR(rig.controller.ask([](VirtualController& c) { return c.analog_output(0); }), 5, 1e-9);
  EXPECT_NEAR(rig.controller.ask([](VirtualController& c) { return c.analog_output(1); }), 1, 1e-9);
}

TEST(UrHardware, ToolsTerminalsTakeTheirNumbersFromTheControllers) {
  Rig rig(Interface::position, free_ports(), [](UrOptions& options) { options.tool_terminals = 6; });
  rig.controller.servers.with([](VirtualController& c) { c.set_inputs(0x300c1, 0, 0); });
  EXPECT_TRUE(rig.tick_until([&] { return rig.input.inputs.digital == 0x00c1; }));
  rig.controller.servers.with([](VirtualController& c) { c.set_inputs(0x201c1, 0, 0); });
  EXPECT_TRUE(rig.tick_until([&] { return rig.input.inputs.digital == 0x0181; }));
  ControllerIo outputs;
  outputs.digital = 0x10c1;
  rig.hardware->set_outputs(outputs);
  const auto reported = [&] { return rig.controller.ask([](VirtualController& c) { return c.digital_outputs(); }); };
  EXPECT_TRUE(rig.tick_until([&] { return reported() == 0x31001u; }));
  outputs.set(6, false);
  rig.hardware->set_outputs(outputs);
  EXPECT_TRUE(rig.tick_until([&] { return reported() == 0x21001u; }));
}

/// Things that are wired to the controller, and to the connector of the tool.
struct WiredJoints : ExactJoints {
  WiredJoints() : ExactJoints(Six{0, -1.5, 1.5, -1.5, -1.5, 0}) {}
  std::optional<ControllerIo> inputs() const override {
    ControllerIo inputs;
    inputs.digital = 0x0102;
    inputs.analog = {1, 2, 3, 4};
    return inputs;
  }
};

TEST(UrHardware, ReadsTheAnalogueInputsOfTheToolBehindTheStandardOnes) {
  const ControllerServers servers(free_ports(), std::make_unique<WiredJoints>());
  UrOptions options;
  options.address = "127.0.0.1";
  options.rtde_port = servers.ports().rtde;
  options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
  options.timeout = 30;
  const SixJoints model(Interface::position);
  UrHardware hardware(options, model, kPeriod);
  hardware.open();
  edp::HardwareInput input;
  for (Tick tick = 1; input.inputs.digital != 0x0102; ++tick) {
    ASSERT_LT(tick, 1000u);
    edp::Beat beat;
    ASSERT_TRUE(hardware.clock()->wait(clock::monotonic_ns() + 30 * clock::kSecond, beat));
    hardware.read(tick, input);
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(input.inputs.analog[i], static_cast<double>(i + 1)) << i;
}

TEST(UrHardware, ACb3SendsAt125Hz) {
  ControllerServers::Options cb3 = free_ports();
  cb3.controller.version = {3, 15, 8, 1};
  Rig rig(Interface::position, cb3);
  ASSERT_TRUE(rig.start());
  rig.rate[0] = 20;
  const double before = rig.joints()[0];
  rig.ticks(200);
  EXPECT_GT(rig.joints()[0], before + 0.02);
  EXPECT_TRUE(rig.healthy());
  const LinkCounters first = rig.hardware->link_counters();
  const double begin = rig.hardware->state().timestamp;
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->link_counters().packages >= first.packages + 20; }));
  EXPECT_NEAR((rig.hardware->state().timestamp - begin) / 0.008, 20, 2.1);
}

TEST(UrHardware, RarePackagesDoNotShortenTheWatchdog) {
  Rig rig(Interface::position, free_ports(), [](UrOptions& options) { options.frequency = 20; });
  ASSERT_TRUE(rig.start());
  rig.ticks(5);
  EXPECT_TRUE(rig.healthy());
}

TEST(UrHardware, OpenNamesTheAddressAndTheProblem) {
  const SixJoints model(Interface::position);
  UrOptions options;
  std::string text;
  {
    Controller controller;
    options = controller.driver_options();
  }
  try {
    UrHardware(options, model, kPeriod).open();
  } catch (const HardwareError& error) {
    EXPECT_EQ(error.code(), ErrorCode::hardware_silent);
    text = error.what();
  }
  EXPECT_THAT(text, HasSubstr("127.0.0.1:" + std::to_string(options.rtde_port)));
  EXPECT_THAT(text, HasSubstr("refused"));
}

TEST(UrHardware, OpenMayWaitForTheController) {
  const SixJoints model(Interface::position);
  ControllerServers::Options ports = free_ports();
  UrOptions options;
  {
    Controller controller;
    options = controller.driver_options();
    ports.rtde_port = options.rtde_port;
  }
  options.open_timeout = 60;
  UrHardware hardware(options, model, kPeriod);
  std::unique_ptr<Controller> controller;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    controller = std::make_unique<Controller>(ports);
  });
  EXPECT_NO_THROW(hardware.open());
  later.join();
}

TEST(UrHardware, OpenNamesRegistersThatAnotherClientWrites) {
  Controller controller;
  const SixJoints model(Interface::position);
  UrHardware first(controller.driver_options(), model, kPeriod);
  first.open();
  UrHardware second(controller.driver_options(), model, kPeriod);
  std::string text;
  try {
    second.open();
  } catch (const HardwareError& error) {
    text = error.what();
  }
  EXPECT_THAT(text, HasSubstr("input_int_register_24"));
}

TEST(UrHardware, RejectsInvalidArguments) {
  const SixJoints model(Interface::position), currents(Interface::current);
  UrOptions options;
  EXPECT_THROW(UrHardware(options, model, kPeriod), HardwareError);  // no address
  options.address = "127.0.0.1";
  options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
  EXPECT_NO_THROW(UrHardware(options, model, kPeriod));
  EXPECT_THROW(UrHardware(options, currents, kPeriod), HardwareError);
  EXPECT_THROW(UrHardware(options, edp::Slide(), kPeriod), HardwareError);
  options.script = "/nowhere/control.script";
  EXPECT_THROW(UrHardware(options, model, kPeriod), HardwareError);
  options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
  options.servo_gain = 1;
  EXPECT_THROW(UrHardware(options, model, kPeriod), HardwareError);
}

TEST(UrHardware, ATickAllocatesNothing) {
  for (const Interface interface : {Interface::position, Interface::velocity}) {
    Rig rig(interface);
    ASSERT_TRUE(rig.start());
    std::uint64_t allocated = 0;
    ControllerIo outputs;
    const auto ticks = [&](int count) {
      for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        outputs.set(0, i % 2 == 0);
        ++rig.now;
        const std::uint64_t before = test::thread_allocations();
        rig.hardware->read(rig.now, rig.input);
        rig.hardware->set_points(rig.set, rig.rate);
        rig.hardware->set_outputs(outputs);
        rig.hardware->write(rig.now, rig.rate);
        allocated += test::thread_allocations() - before;
      }
    };
    rig.rate[0] = 5;
    ticks(100);
    rig.controller.servers.with([](VirtualController& c) { c.protective_stop(); });
    ticks(50);
    rig.hardware->enable(false);
    rig.hardware->reset_fault();
    ticks(50);
    rig.controller.servers.cut();
    ticks(50);
    EXPECT_EQ(allocated, 0u);
  }
}

}  // namespace
}  // namespace mrroc::ur::ur_hardware_test
