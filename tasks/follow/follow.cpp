#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>

using namespace mrroc;

/// Follows a curved workpiece of unknown shape: move down until contact, press with 10 N, move along at 50 mm/s.
class Follow : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, -0.12, -0.04)});
    Move({arm}, {}, Hold{arm, 0.3});  // let the arm settle before the force is zeroed
    arm.bias_force();

    ForceLaw law;
    law.admittance[2] = 0.015;  // m/(N s): the workpiece yields by 1 mm per 2 N
    law.inertia[2] = 0.5;
    law.contact(2, -10.0);  // along the tool's z, down
    Move({arm}, {}, ToolVelocity{arm, {0, 0, 0.02}}.until(Touching{arm, 2.0} || Travelled{arm, 0.15}));
    Move({arm}, {}, ForceControl{arm, law}.until(ElapsedSteps{50}));                     // press
    Move({arm}, {}, ForceControl{arm, law, {0, -0.05, 0}}.until(Travelled{arm, 0.24}));  // and move along
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Follow)
