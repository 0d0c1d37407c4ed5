#include "mrroc/robots/posture_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/planned_cell.hpp"
#include "kinematics/chain_model.hpp"
#include "kinematics/chains.hpp"
#include "kinematics/newton.hpp"
#include "mrroc/move.hpp"

namespace mrroc {
namespace {

/// A chain with the same limits for every axis.
std::shared_ptr<const RobotModel> model_of(const kinematics::SerialChain& chain, const JointVector& home) {
  RobotParameters parameters;
  parameters.type = "chain";
  for (int i = 0; i < chain.size(); ++i) {
    AxisParameters& axis = parameters.axes.emplace_back();
    axis.name = "axis " + std::to_string(i + 1);
    axis.position_max = axis.motor_max = 2.9;
    axis.position_min = axis.motor_min = -2.9;
    axis.velocity_max = 2;
    axis.acceleration_max = 8;
    axis.jerk_max = 80;
  }
  parameters.home = home;
  parameters.regulators = {{"standard", parameters.axes}};
  return std::make_shared<kinematics::ChainModel>("nominal", parameters, chain, JointVector::Ones(chain.size()));
}

const JointVector kHome = (JointVector(7) << 0.1, -0.6, 0.2, -2.1, 0.1, 1.6, 0.5).finished();

TEST(PostureMotion, TurnsRedundantAxesWhileTheFlangeStays) {
  const auto model = model_of(kinematics::test::panda(), kHome);
  test::PlannedCell cell(model);
  Robot arm(cell, "arm", RobotModels{model});
  JointVector wished = kHome;
  wished[0] = -0.6;
  wished[2] = 1.0;
  const Pose flange = model->flange(kHome);
  double farthest = 0;
  cell.on_tick = [&](const DesiredState& state, const DesiredState&, const RobotCommand&) {
    const Twist way = kinematics::displacement(flange, model->flange(state.position));
    farthest = std::max(farthest, way.cwiseAbs().maxCoeff());
  };
  Move({arm}, {}, PostureMotion{arm, wished, 0.5});
  const JointVector end = cell.desired().position;
  EXPECT_LT(farthest, 1e-4) << "m or rad";
  EXPECT_GT((end - kHome).cwiseAbs().maxCoeff(), 0.2);
  EXPECT_LT((end - wished).norm(), (kHome - wished).norm());
  // nothing is left to descend along the only free direction
  const Jacobian jacobian = model->jacobian(end, Eigen::Vector3d::Zero());
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  EXPECT_LT(std::abs(svd.matrixV().col(6).dot(Eigen::VectorXd(wished - end))), 2e-3);
}

TEST(PostureMotion, DoesNotMoveARobotWithoutRedundancy) {
  const JointVector home = (JointVector(6) << 0.1, -1.2, 1.4, -1.5, -1.4, 0.3).finished();
  const auto model = model_of(kinematics::test::ur5e(), home);
  test::PlannedCell cell(model);
  Robot arm(cell, "arm", RobotModels{model});
  Move({arm}, {}, PostureMotion{arm, JointVector::Zero(6)});
  EXPECT_EQ(cell.desired().position, home);
}

TEST(PostureMotion, RefusesAPostureBeyondTheLimits) {
  const auto model = model_of(kinematics::test::panda(), kHome);
  test::PlannedCell cell(model);
  Robot arm(cell, "arm", RobotModels{model});
  EXPECT_THROW(PostureMotion(arm, JointVector::Constant(7, 3)), NonFatalError);
  EXPECT_THROW(PostureMotion(arm, JointVector::Zero(6)), NonFatalError);
  EXPECT_THROW(PostureMotion(arm, kHome, 0), NonFatalError);
}

}  // namespace
}  // namespace mrroc
