#include "geometry/joint_motion.hpp"

#include <Eigen/QR>

namespace mrroc {

namespace {

using Decomposition = Eigen::CompleteOrthogonalDecomposition<Jacobian>;

/// The solution of least squares with the least norm, as Decomposition::solve computes it. That allocates where the
/// rank is less than the number of joints.
JointVector least_norm_solution(const Decomposition& decomposition, const Twist& twist) noexcept {
  const Eigen::Index rank = decomposition.rank(), count = decomposition.cols();
  JointVector solution = JointVector::Zero(count);
  if (rank == 0) return solution;
  Twist rotated = twist;
  rotated.applyOnTheLeft(decomposition.matrixQ().setLength(rank).adjoint());
  solution.head(rank) =
      decomposition.matrixT().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(rotated.head(rank));
  double workspace = 0;
  for (Eigen::Index k = 0; rank < count && k < rank; ++k) {
    std::swap(solution[k], solution[rank - 1]);
    solution.segment(rank - 1, count - rank + 1)
        .applyHouseholderOnTheLeft(decomposition.matrixQTZ().row(k).tail(count - rank).adjoint(),
                                   decomposition.zCoeffs()[k], &workspace);
    std::swap(solution[k], solution[rank - 1]);
  }
  return decomposition.colsPermutation() * solution;
}

}  // namespace

JointVector joint_velocity_of(const ToolKinematics& kinematics, const JointVector& joints,
                              const Twist& twist) noexcept {
  Jacobian jacobian = kinematics.jacobian(joints);
  // otherwise the velocities alone would move a joint that the inverse keeps
  if (const int kept = kinematics.model().kept_joint(); kept >= 0) jacobian.col(kept).setZero();
  return least_norm_solution(Decomposition(jacobian), twist);
}

MovingPose tool_motion(const ToolKinematics& kinematics, const DesiredState& joints, double dt) noexcept {
  return mrroc::tool_motion(kinematics, joints.position, joints.velocity, joints.acceleration, dt);
}

double joint_motion(const ToolKinematics& kinematics, const JointVector& joints, const MovingPose& tool, double dt,
                    JointVector& velocity, JointVector& acceleration) noexcept {
  velocity = joint_velocity_of(kinematics, joints, tool.twist);
  const JointVector step = velocity * dt;
  acceleration = (joint_velocity_of(kinematics, joints + step, tool.twist + tool.rate * dt) -
                  joint_velocity_of(kinematics, joints - step, tool.twist - tool.rate * dt)) /
                 (2 * dt);
  return (kinematics.jacobian(joints) * velocity - tool.twist).norm();
}

}  // namespace mrroc
