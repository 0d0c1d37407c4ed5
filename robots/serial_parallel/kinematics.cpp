#include "robots/serial_parallel/kinematics.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.hpp"
#include "robots/serial_parallel/wrist.hpp"

namespace mrroc::serial_parallel {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

Matrix3d hanging() { return Vector3d(1, -1, -1).asDiagonal(); }  // base from tripod, and back

}  // namespace

Kinematics::Kinematics(const Geometry& geometry) noexcept
    : tripod_(geometry),
      base_b_(geometry.base.b),
      platform_to_wrist_(geometry.platform_to_wrist),
      wrist_to_flange_(geometry.wrist_to_flange) {}

bool Kinematics::reaches(const JointVector& joints, double allowance) const noexcept {
  Placement placement;
  return tripod_.assemble(joints.head<3>(), placement) && tripod_.within_limits(placement, allowance);
}

Placement Kinematics::placement(const JointVector& joints) const noexcept {
  Placement placement;
  tripod_.assemble(joints.head<3>(), placement);
  return placement;
}

Pose Kinematics::flange(const JointVector& joints) const noexcept { return flange(placement(joints), joints); }

Pose Kinematics::flange(const Placement& placement, const JointVector& joints) const noexcept {
  const Pose platform = tripod_.platform(placement);
  const Matrix3d rotation = platform.linear() * wrist_rotation(joints.segment<3>(3));
  Pose pose = Pose::Identity();
  pose.linear() = hanging() * rotation;
  pose.translation() =
      hanging() * (platform * Vector3d(0, 0, platform_to_wrist_) + rotation * Vector3d(0, 0, wrist_to_flange_));
  return pose;
}

ErrorCode Kinematics::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return ErrorCode::out_of_workspace;
  const Vector3d centre = hanging() * (flange * Vector3d(0, 0, -wrist_to_flange_));
  const Placement placement = tripod_.placement_of(centre);
  if (!tripod_.within_limits(placement, 0)) return ErrorCode::out_of_workspace;
  const Matrix3d bent = tripod_.platform(placement).linear().transpose() * hanging() * flange.linear();
  Vector3d wrist;
  const ErrorCode code = wrist_angles(bent, near.segment<3>(3), wrist);
  JointVector found(6);
  found << tripod_.legs(placement), wrist;
  if (!found.allFinite()) return ErrorCode::out_of_workspace;
  joints = found;
  return code;
}

void Kinematics::branches(const Pose& flange, const JointVector& near, double allowance,
                          BranchReceiver& receiver) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return;
  const Vector3d centre = hanging() * (flange * Vector3d(0, 0, -wrist_to_flange_));
  const Placement placement = tripod_.placement_of(centre);
  if (!tripod_.within_limits(placement, allowance)) return;
  const Matrix3d bent = tripod_.platform(placement).linear().transpose() * hanging() * flange.linear();
  JointVector joints(6);
  joints.head<3>() = tripod_.legs(placement);
  const auto add = [&](const Vector3d& wrist) {
    joints.tail<3>() = wrist;
    receiver.add(joints, true);
  };
  Vector3d wrist;
  const Vector3d wanted = near.segment<3>(3);
  const ErrorCode code = wrist_angles(bent, wanted, wrist);
  add(wrist);
  if (code != ErrorCode::singular) return add({wrist[0] + pi, -wrist[1], wrist[2] + pi});
  for (int i = 1; i < kFreeSteps && !receiver.found(); ++i) {
    Vector3d other = wanted;
    other[0] += (i % 2 == 0 ? i / 2 : -(i + 1) / 2) * (2 * pi / kFreeSteps);
    wrist_angles(bent, other, wrist);
    add(wrist);
  }
}

Jacobian Kinematics::jacobian(const JointVector& joints, const Vector3d& offset) const noexcept {
  const Placement at = placement(joints);
  const Pose platform = tripod_.platform(at);
  const Vector3d centre = platform * Vector3d(0, 0, platform_to_wrist_);
  const Vector3d arm = hanging() * (flange(at, joints) * offset) - centre;  // from the wrist's centre to the point

  // twists of the wrist's centre per swing, tilt and height
  const double s = base_b_ * std::sin(at.swing), ds = base_b_ * std::cos(at.swing);
  const Vector3d x = platform.linear().col(0), y = platform.linear().col(1);
  Matrix3d velocity, spin;
  spin << Vector3d::UnitY(), x, Vector3d::Zero();
  velocity << Vector3d::UnitY().cross(centre) + y * ds * std::sin(at.tilt), x.cross(centre) + y * s * std::cos(at.tilt),
      platform.linear().col(2);
  const Matrix3d placement_rates = tripod_.leg_rates(at).inverse();

  Matrix3d wrist_axes;
  wrist_axes << Vector3d::UnitZ(), wrist_rotation({joints[3], 0, 0}).col(1),
      wrist_rotation(joints.segment<3>(3)).col(2);

  Jacobian j(6, 6);
  j.block<3, 3>(0, 0) = velocity * placement_rates;
  j.block<3, 3>(3, 0) = spin * placement_rates;
  j.block<3, 3>(0, 3).setZero();
  j.block<3, 3>(3, 3) = platform.linear() * wrist_axes;
  for (int i = 0; i < 6; ++i) {
    const Vector3d axis = j.col(i).tail<3>();
    j.col(i).head<3>() = hanging() * (j.col(i).head<3>() + axis.cross(arm)).eval();
    j.col(i).tail<3>() = hanging() * axis;
  }
  return j;
}

}  // namespace mrroc::serial_parallel
