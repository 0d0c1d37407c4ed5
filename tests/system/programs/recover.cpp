// The arm is sent into a block, stops with a following error, recovers and goes home. In a deployment called "uncaught"
// the task lets the error pass.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "mrroc/ecp.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robots/irb6.hpp"
#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

class Recover : public ecp::Task {
  Irb6 arm{*this};

  /// Goes to `target`; the code of the hardware error that ends it, or `none`.
  ErrorCode go(const Pose& target) {
    try {
      Move({arm}, {}, JointLine{arm, target});
    } catch (const HardwareError& error) {
      std::printf("stopped: %s\n", error.what());
      return error.code();
    }
    return ErrorCode::none;
  }

  void run() override {
    const Pose home = Irb6::tool_down(0.75, 0, 0);
    if (process().deployment().name == "uncaught") Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0, -0.12)});
    require(go(Irb6::tool_down(0.75, 0, -0.12)) == ErrorCode::following_error, "it went through the block");
    // latched: nothing moves it, the cause being over or not
    require(go(home) == ErrorCode::following_error, "it moved with a fault");
    require(go(home) == ErrorCode::following_error, "the fault went by itself");

    arm.recover();
    const JointVector stands = arm.state().joints;
    require(arm.state().enabled, "it is not on");
    require(arm.state().desired_joints == stands, "it is not desired where it is measured");
    require(arm.kinematics().direct(stands).translation().z() < -0.03, "it has not been in the block");

    // no step of the way home is longer than the joints' speeds allow, measured or desired
    JointVector measured = stands, desired = stands;
    double fastest = 0;
    const auto look = [&] {
      const double seconds = arm.step_duration();
      for (Eigen::Index i = 0; i < stands.size(); ++i) {
        const double speed = arm.parameters().axes[static_cast<std::size_t>(i)].velocity_max;
        for (const double way : {arm.state().joints[i] - measured[i], arm.state().desired_joints[i] - desired[i]})
          fastest = std::max(fastest, std::abs(way) / (speed * seconds));
      }
      measured = arm.state().joints;
      desired = arm.state().desired_joints;
      return false;
    };
    Move({arm}, {}, JointLine{arm, home}.until(When{"never", look}));
    Wait({arm}, {}, ElapsedSteps{50});
    std::printf("fastest %.3f of the limit\n", fastest);
    require(fastest > 0.05 && fastest < 1.1, "a joint has jumped");
    const JointVector error = arm.state().joints - arm.parameters().home;
    require(error.cwiseAbs().maxCoeff() < 1e-3, "it did not come home");
    std::printf("recovered\n");
  }
};

}  // namespace

MRROC_ECP(Recover)
