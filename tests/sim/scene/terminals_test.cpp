#include <gtest/gtest.h>

#include "sim/scene/controller_wiring.hpp"
#include "sim/world.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::terminals_test {
namespace {

/// Two slides: a valve on output 3, a heater on analogue output 1; inputs measure both.
constexpr const char* kScene = R"(<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <body name="valve">
      <joint name="valve" type="slide" axis="1 0 0" damping="10"/>
      <geom size="0.01" mass="0.1"/>
    </body>
    <body name="heater">
      <joint name="heater" type="slide" axis="0 1 0" damping="10"/>
      <geom size="0.01" mass="0.1"/>
    </body>
  </worldbody>
  <actuator>
    <position name="arm/output_3" joint="valve" kp="100" ctrlrange="-0.02 0.05" ctrllimited="true"/>
    <position name="arm/analog_output_1" joint="heater" kp="100"/>
    <motor name="arm/output_4" joint="heater" gear="0"/>
  </actuator>
  <sensor>
    <jointpos name="arm/input_0" joint="valve"/>
    <jointpos name="arm/analog_input_7" joint="heater"/>
    <jointpos name="other/input_1" joint="valve"/>
  </sensor>
</mujoco>)";

TEST(ControllerWiring, AreWiredToTheWorldByName) {
  const task_test::ScratchFolder scratch;
  World world(compose_texts(scratch, kScene), 0.002, 0.001);
  const ControllerWiring terminals(world.model(), "arm");
  world.start();
  ControllerIo outputs;
  outputs.set(3, true);
  outputs.set(5, true);  // not connected
  outputs.analog[1] = -0.3;
  terminals.write(world.model(), world.data(), outputs);
  for (Tick k = 1; k <= 1000; ++k) world.step(k);
  ControllerIo inputs = terminals.read(world.data());
  EXPECT_EQ(inputs.digital, 1u) << "the valve is at 0.05; no other input is connected";
  EXPECT_NEAR(inputs.analog[7], -0.3, 1e-3);
  EXPECT_EQ(inputs.analog[0], 0);

  outputs.set(3, false);
  terminals.write(world.model(), world.data(), outputs);
  for (Tick k = 1001; k <= 2000; ++k) world.step(k);
  EXPECT_EQ(terminals.read(world.data()).digital, 0u) << "the lower end of its range is -0.02";
}

TEST(ControllerWiring, OnIsOneWhenTheActuatorHasNoRange) {
  const task_test::ScratchFolder scratch;
  World world(compose_texts(scratch, kScene), 0.002, 0.001);
  const ControllerWiring terminals(world.model(), "arm");
  ControllerIo outputs;
  outputs.set(4, true);
  terminals.write(world.model(), world.data(), outputs);
  const int actuator = mj_name2id(&world.model(), mjOBJ_ACTUATOR, "arm/output_4");
  ASSERT_GE(actuator, 0);
  EXPECT_EQ(world.data().ctrl[actuator], 1);
  terminals.write(world.model(), world.data(), ControllerIo{});
  EXPECT_EQ(world.data().ctrl[actuator], 0);
}

}  // namespace
}  // namespace mrroc::sim::terminals_test
