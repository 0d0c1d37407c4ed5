#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/sensors/force_torque.hpp>
#include <mrroc/sensors/ultrasonic.hpp>

using namespace mrroc;

/// A part slides under the arm: wait for it, move down until the wrist measures 10 N, hold for 0.5 s, move back.
class Press : public ecp::Task {
  Irb6 arm{*this};
  ForceTorque wrist{*this, "wrist"};
  Ultrasonic gate{*this, "gate"};

  void run() override {
    Wait({arm}, {gate}, Closer{gate, 0.10});                             // a part has come
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0.2, -0.05)});  // above it
    Move({arm}, {}, Hold{arm, 0.3});  // let the arm settle before the force is zeroed
    wrist.bias();
    const Outcome end = Move({arm}, {wrist},
                             ToolVelocity{arm, {0, 0, 0.02}}  // down ...
                                 .until(ForceAbove{wrist, 10.0} || Travelled{arm, 0.15}));
    if (end.by<Travelled>()) throw NonFatalError{"no part under the tool"};
    Move({arm}, {wrist}, Hold{arm, 0.5});
    Move({arm}, {wrist}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Press)
