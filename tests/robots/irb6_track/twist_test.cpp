#include <gtest/gtest.h>

#include "edp/command/planner.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc::edp {
namespace {

constexpr double kPeriod = 0.002;
constexpr int kSteps = 10;

/// Plans a line of the tool along the track at `speed` (m/s) for two seconds, commanded like a generator: pose and
/// twist every macrostep. Returns the joints at its end; an error fails the test.
JointVector line_along_the_track(const RobotModel& model, double speed) {
  const ToolKinematics kinematics(model);
  Planner planner(model, kPeriod);
  Macrostep macrostep;
  DesiredState state = DesiredState::resting_at(model.parameters().home);
  Pose pose = kinematics.direct(state.position);
  const double from = pose.translation().y();
  for (int i = 1; i <= 100; ++i) {
    // the speed rises as u^2 (3 - 2u), u = t / D, in a third of the time
    constexpr double kRamp = 35 * kSteps * kPeriod;
    const double t = i * kSteps * kPeriod, u = std::min(t / kRamp, 1.0);
    RobotCommand command;
    command.kind = CommandKind::pose;
    command.motion_steps = command.reply_step = kSteps;
    pose.translation().y() = from + speed * (u < 1 ? kRamp * u * u * u * (1 - u / 2) : t - kRamp / 2);
    command.pose = pose;
    command.twist[1] = speed * (u * u * (3 - 2 * u));
    command.twist_acceleration = JointVector::Zero(6);
    command.twist_acceleration[1] = speed * (6 * u * (1 - u) / kRamp);
    const ErrorReport report = planner.plan(command, state, Pace::as_commanded, macrostep);
    EXPECT_EQ(report.code, ErrorCode::none) << model.name() << ", step " << i << ": " << report.detail.view();
    if (report.error_class != ErrorClass::none) break;
    state = macrostep.to;
  }
  return state.position;
}

// velocities of least norm would move the joint that the inverse keeps, so that no path would connect the two
TEST(Irb6TrackTwist, KeptJointIsAtRestAlongALineOfPosesAndTwists) {
  const JointVector home = robot().parameters().home;
  for (const double speed : {0.05, -0.05}) {
    const double way = speed * (2 - 0.35);
    const JointVector still = line_along_the_track(*robot_under_test().models.at(0), speed);
    EXPECT_EQ(still[0], home[0]);
    EXPECT_GT(std::abs(still[1] - home[1]), 0.05) << "the column turned instead";
    const JointVector used = line_along_the_track(*robot_under_test().models.at(1), speed);
    EXPECT_NEAR(used[0], home[0] + way, 1e-9);
    EXPECT_NEAR(used[1], home[1], 1e-9);
  }
}

}  // namespace
}  // namespace mrroc::edp
