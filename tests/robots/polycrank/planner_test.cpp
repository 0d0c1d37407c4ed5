#include "edp/command/planner.hpp"

#include <gtest/gtest.h>

#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::edp::planner_test {
namespace {

constexpr double kPeriod = 0.002;
constexpr int kSteps = 10;

/// Plans a line of the tool at `velocity` (m/s) for two seconds with half a second of run-up, commanded like a
/// generator: pose and twist every macrostep. Returns the first error.
ErrorReport line(const Eigen::Vector3d& velocity, const JointVector& start, JointVector& end) {
  const ToolKinematics kinematics(polycrank_model());
  Planner planner(polycrank_model(), kPeriod);
  Macrostep macrostep;
  DesiredState state = DesiredState::resting_at(start);
  Pose pose = kinematics.direct(start);
  const Eigen::Vector3d from = pose.translation();
  for (int i = 1; i <= 100; ++i) {
    // the speed rises as u^2 (3 - 2u), u = t / D, within a third of the time
    constexpr double kRamp = 35 * kSteps * kPeriod;
    const double t = i * kSteps * kPeriod, u = std::min(t / kRamp, 1.0);
    const double way = u < 1 ? kRamp * u * u * u * (1 - u / 2) : t - kRamp / 2;
    RobotCommand command;
    command.kind = CommandKind::pose;
    command.motion_steps = kSteps;
    command.reply_step = kSteps;
    pose.translation() = from + velocity * way;
    command.pose = pose;
    command.twist << velocity * (u * u * (3 - 2 * u)), Eigen::Vector3d::Zero();
    command.twist_acceleration = JointVector::Zero(6);
    command.twist_acceleration.head<3>() = velocity * (6 * u * (1 - u) / kRamp);
    const ErrorReport report = planner.plan(command, state, Pace::as_commanded, macrostep);
    if (report.error_class != ErrorClass::none) return report;
    state = macrostep.to;
  }
  end = state.position;
  return {};
}

// the planner's velocities are those of least norm: the inverse must move the joints in the same direction
TEST(PolycrankPlanner, LinesOfTheToolKeepTheLimits) {
  for (const Eigen::Vector3d& velocity :
       {Eigen::Vector3d(0.04, 0, 0), {-0.04, 0, 0}, {0, 0.04, 0}, {0, -0.04, 0}, {0, 0, 0.04}, {0, 0, -0.04}}) {
    JointVector end;
    const ErrorReport report = line(velocity, polycrank_home(), end);
    EXPECT_EQ(report.code, ErrorCode::none) << velocity.transpose() << ": " << report.detail.view();
  }
}

TEST(PolycrankPlanner, IsIndependentOfAHundredTurns) {
  const JointVector turns = JointVector::Constant(7, 2 * M_PI * 100);
  JointVector here, away;
  ASSERT_EQ(line({0, 0.05, 0}, polycrank_home(), here).code, ErrorCode::none);
  ASSERT_EQ(line({0, 0.05, 0}, polycrank_home() + turns, away).code, ErrorCode::none);
  EXPECT_LT((away - here - turns).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace mrroc::edp::planner_test
