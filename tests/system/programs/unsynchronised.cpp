// Synchronises the arm, continues with another tool and the calibrated model, and checks the states on the way.
#include <cmath>
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robots/irb6.hpp"
#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

class Unsynchronised : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    try {
      Move({arm}, {}, JointLine(arm, arm.parameters().home));
      throw NonFatalError(ErrorCode::task_failed, "the arm moved its joints before it was synchronised");
    } catch (const NonFatalError& error) {
      if (error.code() != ErrorCode::not_synchronised) throw;
      std::printf("before: not synchronised\n");
    }
    arm.synchronise();
    require(arm.state().synchronised, "it is not synchronised");
    // every motor has stopped soon after its synchronisation position, the tool roll from 25 rad/s
    for (std::size_t i = 0; i < 6; ++i)
      require(std::abs(arm.state().motors[static_cast<Eigen::Index>(i)] - arm.parameters().axes[i].motor_synchro) < 6,
              "a motor is far from its synchronisation position");
    Move({arm}, {}, JointLine(arm, arm.parameters().home));
    require((arm.state().joints - arm.parameters().home).cwiseAbs().maxCoeff() < 1e-2, "it did not reach home");

    const Pose with_tool = arm.state().desired_pose;
    arm.set_tool(Pose::Identity());
    require(arm.state().desired_pose.isApprox(with_tool * arm.models().front()->default_tool().inverse(), 1e-9),
            "the pose is not the flange's");
    const JointVector motors = arm.state().motors;
    arm.use_model("calibrated");
    require(arm.kinematics().model().name() == "calibrated", "it uses another model");
    require((arm.state().motors - motors).cwiseAbs().maxCoeff() < 0.1, "the change of the model moved the arm");
    std::printf("after: synchronised\n");
  }
};

}  // namespace

MRROC_ECP(Unsynchronised)
