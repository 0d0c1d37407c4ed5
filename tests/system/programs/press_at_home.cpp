#include <mrroc/ecp.hpp>
#include <mrroc/robots/arm.hpp>
#include <mrroc/sensors/force_torque.hpp>

using namespace mrroc;

/// What the task press does, with any arm, below the place where its tool is at home.
template <class AnyArm>
class PressAtHome : public ecp::Task {
  AnyArm arm{*this};
  ForceTorque wrist{*this, "wrist"};

  void run() override {
    Move({arm}, {}, Hold{arm, 0.3});
    wrist.bias();
    const Outcome end =
        Move({arm}, {wrist}, ToolVelocity{arm, {0, 0, 0.02}}.until(ForceAbove{wrist, 10.0} || Travelled{arm, 0.1}));
    if (end.by<Travelled>()) throw NonFatalError{"no part under the tool"};
    Move({arm}, {wrist}, Hold{arm, 0.5});
    Move({arm}, {wrist}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(PressAtHome<Arm>)
