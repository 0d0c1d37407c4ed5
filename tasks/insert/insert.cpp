#include <cmath>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/spiral_search.hpp>
#include <mrroc/robots/irb6.hpp>
#include <random>

using namespace mrroc;

/// Puts a peg of 20 mm into a hole of 20.5 mm, ten times, each time from a random start up to 2 mm beside it: down
/// until it touches, search in a spiral while pressing, insert it compliantly between the walls, move back.
class Insert : public ecp::Task {
  Irb6 arm{*this};

  static constexpr double kDepth = 0.025;  // m

  double height() const { return arm.state().pose.translation().z(); }

  /// Presses with `force` N along the tool's z; x and y yield, and so do the rotations, when `soft`.
  static ForceLaw press(double force, bool soft) {
    ForceLaw law;
    law.inertia << 5, 5, 1, 0.5, 0.5, 0.5;
    law.admittance << 0.001, 0.001, 0.005, 0.1, 0.1, 0.1;
    law.contact(2, -force);
    if (soft) law.guarded(0).guarded(1).guarded(3).guarded(4);
    return law;
  }

  void insert(double x, double y) {
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(x, y, -0.12)});
    Move({arm}, {}, Hold{arm, 0.3});  // let the arm settle before the force is zeroed
    arm.bias_force();
    Move({arm}, {}, ToolVelocity{arm, {0, 0, 0.01}}.until(Touching{arm, 2.0} || Travelled{arm, 0.05}));
    Move({arm}, {}, ForceControl{arm, press(8, false)}.until(ElapsedSteps{25}));
    const double top = height();
    const auto lower_by = [this, top](double way) { return [this, top, way] { return height() < top - way; }; };
    Move({arm}, {}, SpiralSearch{arm, press(8, false), 0.0004, 0.0025, 0.006}.until(When{"found", lower_by(0.001)}))
        .require("found", "there is no hole");
    Move({arm}, {}, ForceControl{arm, press(10, true)}.until(When{"in", lower_by(kDepth)} || ElapsedSteps{250}))
        .require("in", "the peg is stuck");
    ForceLaw out = press(0, false);
    out.guarded(0).guarded(1);  // the axes stay: a peg that rotates as it yields swings from wall to wall
    out.behaviour[2] = AxisBehaviour::unguarded;
    Move({arm}, {}, ForceControl{arm, out, {0, 0, -0.03}}.until(Travelled{arm, 0.05}));
  }

  void run() override {
    arm.set_tool(Pose(Eigen::Translation3d(0, 0, 0.31)));  // the tip of the peg
    std::mt19937 random{20};
    const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0; };  // 0 to 1
    for (int trial = 0; trial < 10; ++trial) {
      const double error = 0.002 * number(), direction = 6.283185307 * number();
      insert(0.75 + error * std::cos(direction), error * std::sin(direction));
    }
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Insert)
