#include "edp/force/damped_inverse.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/joint_motion.hpp"

namespace mrroc::edp {

namespace {

using Six = Eigen::Matrix<double, 6, 1>;

constexpr double kZero = 1e-14;  // of the largest eigenvalue: smaller ones are zero

/// W twist, or W J.
template <class Rows>
Rows weighted(Rows rows) noexcept {
  rows.template bottomRows<3>() *= kTwistLength;
  return rows;
}

}  // namespace

double speed_of(const Twist& twist) noexcept { return weighted(twist).norm(); }

DampedVelocity damped_joint_velocity(const ToolKinematics& kinematics, const JointVector& joints,
                                     const Twist& twist) noexcept {
  const RobotModel& model = kinematics.model();
  DampedVelocity result{joint_velocity_of(kinematics, joints, twist)};
  Jacobian jacobian = kinematics.jacobian(joints);
  int free_joints = model.joint_count();
  if (const int kept = model.kept_joint(); kept >= 0) {
    jacobian.col(kept).setZero();
    --free_joints;
  }
  if (free_joints == 0) return result;
  const Jacobian a = weighted(jacobian);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(a.lazyProduct(a.transpose()).eval());
  const Six& squares = eigen.eigenvalues();  // ascending

  std::array<double, 6> speed{};
  const int first = 6 - std::min(6, free_joints);  // fewer joints reach no other directions, wherever they are
  for (int i = first; i < 6; ++i) {
    if (!(squares[i] > kZero * squares[5])) continue;
    const JointVector rates = a.transpose() * eigen.eigenvectors().col(i) / squares[i];
    double slowest = 0;  // s for 1 m
    for (Eigen::Index j = 0; j < rates.size(); ++j)
      slowest =
          std::max(slowest, std::abs(rates[j]) / model.parameters().axes[static_cast<std::size_t>(j)].velocity_max);
    speed[static_cast<std::size_t>(i)] = 1 / slowest;
  }
  const double least = kLostPart * *std::max_element(speed.begin(), speed.end());
  const double weakest = *std::min_element(speed.begin() + first, speed.end());
  result.near = weakest < kNear * least;
  if (weakest >= least) return result;

  const Six wanted = weighted(free_joints < 6 ? Twist(jacobian * result.velocity) : twist);
  Six followed = Six::Zero();
  for (int i = first; i < 6; ++i) {
    const double part = std::min(1.0, speed[static_cast<std::size_t>(i)] / least);
    if (part == 0) continue;
    const auto direction = eigen.eigenvectors().col(i);
    followed += part * part / squares[i] * direction.dot(wanted) * direction;
  }
  result.velocity = a.transpose() * followed;
  result.damped = true;
  return result;
}

}  // namespace mrroc::edp
