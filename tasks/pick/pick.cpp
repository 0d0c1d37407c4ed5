#include <mrroc/mp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/robots/two_finger_gripper.hpp>

using namespace mrroc;

/// An arm with a gripper picks up a cube, carries it to the other side of the table and puts it down.
class Pick : public mp::Task {
  Irb6 arm{*this, "arm"};
  TwoFingerGripper gripper{*this, "gripper"};

  /// The arm's tool pose with the pads around (x, y, z) m in the arm's base frame, fingers down.
  Pose around(double x, double y, double z) const { return Irb6::tool_down(x, y, z) * gripper.grip_centre().inverse(); }

  void run() override {
    Move({arm, gripper}, {}, JointLine{gripper, TwoFingerGripper::at(0.085), 0.9});
    Move({arm, gripper}, {}, JointLine{arm, around(0.72, 0.15, -0.08)});
    Move({arm, gripper}, {}, JointLine{arm, around(0.72, 0.15, -0.18), 0.3});
    Move({arm, gripper}, {}, JointLine{gripper, TwoFingerGripper::at(0.055), 0.9}.until(Gripped{gripper}))
        .require<Gripped>("no cube between the fingers");
    for (const double y : {0.15, -0.15}) {
      const Outcome way =
          Move({arm, gripper}, {}, JointLine{arm, around(0.72, y, -0.08), 0.3}.until(!Gripped{gripper}));
      if (way.by<Negated>()) throw NonFatalError{"the cube has been lost"};
    }
    Move({arm, gripper}, {}, JointLine{arm, around(0.72, -0.15, -0.179), 0.3});
    Move({arm, gripper}, {}, JointLine{gripper, TwoFingerGripper::at(0.085), 0.9});
    Move({arm, gripper}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_MP(Pick)
