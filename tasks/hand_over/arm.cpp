#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>

#include "hand_over.hpp"
using namespace mrroc;

/// The behaviours of both arms.
struct Arm : ecp::Task {
  Irb6 arm{*this};

  Arm() {
    on<Reach>([this](const Reach& to) {
      arm.set_tool(Pose{Eigen::Translation3d{0, -0.08, 0.378}});  // of the bar, in the flange frame
      const Pose place = Irb6::tool_down(to.x, to.y, to.z) * Eigen::AngleAxisd{-to.turn, Eigen::Vector3d::UnitZ()};
      Move({arm}, {}, ToolVelocity{arm, {0, 0, -0.06}}.until(Travelled{arm, 0.06}));
      Move({arm}, {}, JointLine{arm, Eigen::Translation3d{0, 0, 0.06} * place, 0.9});
      Move({arm}, {}, Hold{arm, 0.2});  // let the arm settle before the force is zeroed
      arm.bias_force();
      Move({arm}, {}, JointLine{arm, place, 0.2}.until(Touching{arm, 5.0}));
    });
    on<Give>([this](const Give&) {
      const When pulled{"pulled",
                        [this] { return -arm.state().wrench[1] > 6; }};  // N, along the bar, away from the hand
      Wait({arm}, {}, pulled || ElapsedSteps{1000}).require("pulled", "the bar was not pulled");
    });
    on<Take>([this](const Take&) {
      ForceLaw law = ForceLaw{}.guarded(0).guarded(1).guarded(2).guarded(3).guarded(4).guarded(5);
      law.admittance << 3e-4, 3e-4, 3e-4, 3e-3, 3e-3, 3e-3;  // m/(N s), rad/(N m s): two hands are stiff
      Move({arm}, {}, ForceControl{arm, law});
      Move({arm}, {}, ForceControl{arm, law.contact(1, -10)});
    });
  }
};

MRROC_ECP(Arm)
