// The arm is sent into a block, stops with a following error, recovers and moves home. In a deployment called
// "uncaught" the task does not catch the error.
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

  /// Moves to `target`; returns the code of the hardware error that ends it, or `none`.
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
    // latched: no command moves it, with or without the cause
    require(go(home) == ErrorCode::following_error, "it moved with a fault");
    require(go(home) == ErrorCode::following_error, "the fault cleared itself");

    arm.recover();
    const JointVector stands = arm.state().joints;
    require(arm.state().enabled, "it is not on");
    require(arm.state().desired_joints == stands, "the desired position is not the measured one");
    require(arm.kinematics().direct(stands).translation().z() < -0.03, "it has not been in the block");

    // no step of the path home is longer than the joints' speeds allow, measured or desired
    JointVector measured = stands, desired = stands;
    double fastest = 0;
    const auto check = [&] {
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
    Move({arm}, {}, JointLine{arm, home}.until(When{"never", check}));
    Wait({arm}, {}, ElapsedSteps{50});
    std::printf("fastest %.3f of the limit\n", fastest);
    require(fastest > 0.05 && fastest < 1.1, "a joint has jumped");
    const JointVector error = arm.state().joints - arm.parameters().home;
    require(error.cwiseAbs().maxCoeff() < 1e-3, "it did not reach home");
    std::printf("recovered\n");
  }
};

}  // namespace

MRROC_ECP(Recover)
