// Swings the column into a pillar, and prints where the robot stops.
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"

using namespace mrroc;

namespace {

class Collide : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    JointVector target = arm.parameters().home;
    target[0] += 1.4;
    try {
      Move({arm}, {}, JointLine{arm, target, 1.0});
      std::printf("nothing in the way\n");
    } catch (const HardwareError& error) {
      const RobotState& state = arm.state();
      std::printf("code %d tick %llu set-point %.6f\n", static_cast<int>(error.code()),
                  static_cast<unsigned long long>(error.origin().tick), state.desired_joints[0] - state.joints[0]);
    }
  }
};

}  // namespace

MRROC_ECP(Collide)
