#include <mrroc/ecp.hpp>
#include <mrroc/robots/two_finger_gripper.hpp>

using namespace mrroc;

/// Opens wide, closes on a cube until contact, holds it for a second and releases it.
class TwoFingerGripperDemo : public ecp::Task {
  TwoFingerGripper gripper{*this};

  void run() override {
    Move({gripper}, {}, JointLine{gripper, TwoFingerGripper::at(0.089), 0.9});
    Move({gripper}, {}, JointLine{gripper, TwoFingerGripper::at(0.055), 0.9}.until(Gripped{gripper}))
        .require<Gripped>("nothing between the fingers");
    Move({gripper}, {}, Hold{gripper, 1.0});
    Move({gripper}, {}, JointLine{gripper, gripper.parameters().home, 0.9});
  }
};

MRROC_ECP(TwoFingerGripperDemo)
