// The arm moves to and fro until an emergency stop ends that, waits for the reset, and moves home. In a deployment
// named `input` it presses the stop itself, through the output that the loopback connects to the emergency-stop input.
#include <cstdio>
#include <functional>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

constexpr int kTerminal = 3;

class EmergencyStop : public ecp::Task {
  Irb6 arm{*this};

  void press(bool pressed) {
    ControllerIo outputs;
    outputs.set(kTerminal, !pressed);  // active low
    arm.set_outputs(outputs);
  }

  /// Whether the emergency stop ends `instruction`.
  static bool stopped(const std::function<void()>& instruction) {
    try {
      instruction();
    } catch (const HardwareError& error) {
      std::printf("stopped: %s\n", error.what());
      std::fflush(stdout);
      require(error.code() == ErrorCode::emergency_stop, "another error");
      return true;
    }
    return false;
  }

  void run() override {
    const Pose home = Irb6::tool_down(0.75, 0, 0);
    const Pose aside = Irb6::tool_down(0.75, 0.2, 0);
    const bool by_input = process().deployment().name == "input";
    std::printf("moves\n");
    std::fflush(stdout);
    if (by_input) {
      Move({arm}, {}, JointLine{arm, aside});
      press(true);
    }
    while (!stopped([&] {
      Move({arm}, {}, JointLine{arm, aside});
    }) && !stopped([&] {
      Move({arm}, {}, JointLine{arm, home});
    })) {
    }
    require(stopped([&] { Move({arm}, {}, JointLine{arm, home}); }), "it moved with the stop pressed");
    if (by_input) require(stopped([&] { press(false); }), "outputs are set and the fault is reported");

    // the arm has come to rest, and stays there until it is instructed to move, reset or not
    JointVector stands;
    Tick pressed = 0;
    for (bool recovered = false; !recovered;) {
      try {
        arm.recover();
        recovered = true;
      } catch (const HardwareError& error) {
        require(error.code() == ErrorCode::emergency_stop, "another error");
      }
      if (pressed == 0) pressed = arm.state().tick;
      require(arm.state().tick < pressed + 5000, "the emergency stop was not reset");
      if (arm.state().tick < pressed + 300) continue;  // it brakes, then the drives' brakes hold it
      if (stands.size() == 0) stands = arm.state().joints;
      require(arm.state().joints == stands, "it moved before it was recovered");
    }
    require(stands.size() != 0, "it recovered at once");
    require(arm.state().enabled, "it is not on");
    Wait({arm}, {}, ElapsedSteps{20});
    require(arm.state().desired_joints == stands, "it moved without a command");
    Move({arm}, {}, JointLine{arm, home});
    require((arm.state().joints - arm.parameters().home).cwiseAbs().maxCoeff() < 1e-3, "it did not reach home");
    std::printf("went on\n");
  }
};

}  // namespace

MRROC_ECP(EmergencyStop)
