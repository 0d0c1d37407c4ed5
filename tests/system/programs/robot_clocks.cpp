// Three arms in step: two whose controllers keep the time, one on the clock of the deployment.
#include <cstdio>

#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/mp.hpp"
#include "mrroc/robots/irb6.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class RobotClocks : public mp::Task {
  Irb6 slow{*this, "slow"};
  Irb6 fast{*this, "fast"};
  Irb6 common{*this, "common"};

  void run() override {
    Wait({slow, fast, common}, {}, ElapsedSteps{1});
    for (int i = 0; i < 6; ++i) {
      const double way = i % 2 == 0 ? 0.3 : -0.3;
      const Outcome outcome = Move({slow, fast, common}, {}, Together{by(slow, way), by(fast, -way), by(common, way)});
      std::printf("skew %llu ticks\n", static_cast<unsigned long long>(outcome.skew));
    }
  }

  static JointLine by(Irb6& arm, double way) {
    JointVector joints = arm.state().desired_joints;
    joints[0] += way;
    return JointLine{arm, joints, 0.5};
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_MP(mrroc::test::RobotClocks)
