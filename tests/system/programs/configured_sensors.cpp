// A task that says what its tool carries, to its wrist sensor and to its robot, and changes what a range sensor sees.
#include <cmath>
#include <cstdio>
#include <mrroc/conditions/elapsed_time.hpp>
#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/sensors/force_torque.hpp>
#include <mrroc/sensors/ultrasonic.hpp>

#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

/// The tool of the IRb-6 weighs 1.1 kg; the deployment's 0.1 kg makes 1 kg of it the load.
const Load kLoad{1.0, {0.004, 0, 0.066}};

class ConfiguredSensors : public ecp::Task {
  Irb6 arm{*this};
  ForceTorque wrist{*this, "wrist"};
  Ultrasonic gate{*this, "gate"};

  void turn(double roll) {
    JointVector posture = arm.parameters().home;
    posture[4] += roll;
    Move({arm}, {wrist, gate}, JointLine{arm, posture});
    Move({arm}, {wrist, gate}, Hold{arm, 0.6});
    std::printf("configuration %u: wrist %.2f N, arm %.2f N\n", wrist.reading().configuration, wrist.force().norm(),
                arm.state().wrench.head<3>().norm());
  }

  template <class Refused>
  void refuses(Sensor& sensor, const Refused& configuration) {
    const std::uint32_t before = sensor.configuration();
    try {
      sensor.configure(configuration);
    } catch (const NonFatalError& error) {
      require(error.code() == ErrorCode::invalid_argument, "the refusal has another code");
      require(sensor.configuration() == before, "a refusal has changed the number");
      return;
    }
    require(false, "an impossible configuration is taken");
  }

  void run() override {
    arm.set_tool(arm.kinematics().tool() * Eigen::Translation3d(0, 0, 0.05));
    turn(0);
    require(wrist.force().norm() > 8, "the load's weight is not measured");
    require(arm.state().wrench.head<3>().norm() > 8, "the robot does not measure it");

    refuses(wrist, Carrying{-1, kLoad.centre});
    refuses(wrist, UltrasonicRange{0.1, 0.5});
    refuses(gate, UltrasonicRange{0.1, 1e6});
    wrist.configure(Carrying{kLoad.mass, kLoad.centre});                 // in the sensor frame, here the flange's
    arm.carry({kLoad.mass, arm.state().tool.inverse() * kLoad.centre});  // in the tool frame, to its EDP
    require(std::isnan(wrist.force().x()), "the reading of the old configuration is kept");
    for (const double roll : {0.0, -1.6, -0.8}) {
      turn(roll);
      require(wrist.reading().configuration == 1, "the reading was made with another configuration");
      require(wrist.force().norm() < 0.3 && wrist.torque().norm() < 0.03, "the load's weight remains");
      require(arm.state().wrench.head<3>().norm() < 0.3, "the load's weight remains for the robot");
    }

    require(gate.detected(), "the gate sees no floor");
    const double seen = gate.distance();
    gate.configure(UltrasonicRange{0.05, seen - 0.1});
    require(std::isnan(gate.distance()), "the published reading of the old configuration is kept");
    Wait({arm}, {gate}, ElapsedTime{*this, 0.2});
    require(gate.reading().configuration == 1 && !gate.detected(), "the gate still sees it");
  }
};

}  // namespace

MRROC_ECP(ConfiguredSensors)
