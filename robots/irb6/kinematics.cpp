#include "robots/irb6/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mrroc::irb6 {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kSingular = 1e-10;      // |sin q5|, or m from the column's axis
constexpr double kRotationError = 1e-6;  // of a pose's rotation matrix
constexpr double kStretch = 1e-12;       // rounding of cos(elbow) at full stretch

// Axes of a frame that is turned by `column` about the base's z axis and by `pitch` about the arm's common axis.
struct ArmAxes {
  ArmAxes(double column, double pitch)
      : along(std::cos(column) * std::cos(pitch), std::sin(column) * std::cos(pitch), -std::sin(pitch)),
        side(-std::sin(column), std::cos(column), 0),
        normal(std::cos(column) * std::sin(pitch), std::sin(column) * std::sin(pitch), std::cos(pitch)) {}
  Vector3d along, side, normal;
};

double nearest_turn(double angle, double near) { return near + std::remainder(angle - near, 2 * pi); }

bool is_rigid(const Pose& pose) {
  const Eigen::Matrix3d r = pose.linear();
  // written so that a value that is not a number fails
  return pose.translation().allFinite() && (r.transpose() * r - Eigen::Matrix3d::Identity()).norm() < kRotationError &&
         r.determinant() > 0;
}

}  // namespace

Kinematics::Kinematics(const Geometry& geometry) noexcept
    : lower_arm_(geometry.lower_arm), upper_arm_(geometry.upper_arm), wrist_(geometry.wrist) {}

Pose Kinematics::flange(const JointVector& joints) const noexcept {
  const double t2 = joints[1];
  const double t3 = t2 + joints[2] + pi / 2;
  const double t4 = t3 + joints[3];
  const ArmAxes arm(joints[0], t4);
  const double c5 = std::cos(joints[4]), s5 = std::sin(joints[4]);
  const double c6 = std::cos(joints[5]), s6 = std::sin(joints[5]);
  const Vector3d rolled = arm.normal * c5 - arm.side * s5;
  const double r = lower_arm_ * std::cos(t2) + upper_arm_ * std::cos(t3) + wrist_ * std::cos(t4);
  Pose pose = Pose::Identity();
  pose.linear().col(0) = rolled * c6 + arm.along * s6;
  pose.linear().col(1) = arm.along * c6 - rolled * s6;
  pose.linear().col(2) = arm.normal * s5 + arm.side * c5;
  pose.translation() << std::cos(joints[0]) * r, std::sin(joints[0]) * r,
      -lower_arm_ * std::sin(t2) - upper_arm_ * std::sin(t3) - wrist_ * std::sin(t4);
  return pose;
}

ErrorCode Kinematics::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return ErrorCode::out_of_workspace;
  const Vector3d p = flange.translation();
  const double r = std::hypot(p.x(), p.y());
  const bool above_shoulder = r < kSingular;
  const double q1 = above_shoulder ? near[0] : std::atan2(p.y(), p.x());

  // the flange's z axis is sin q5 (cos t4 up + sin t4 forward) + cos q5 sideways
  const ArmAxes level(q1, 0);
  const Vector3d axis = flange.linear().col(2);
  const double forward = axis.dot(level.along), up = axis.z(), sideways = axis.dot(level.side);
  const double sine5 = std::hypot(forward, up);
  const bool rolls_aligned = sine5 < kSingular;

  double least = std::numeric_limits<double>::infinity();
  JointVector best(6);
  for (const double sign : {1.0, -1.0}) {
    const double t4 = rolls_aligned ? near[1] + near[2] + near[3] + pi / 2 : std::atan2(sign * forward, sign * up);
    const ArmAxes arm(q1, t4);
    const double e = r - wrist_ * std::cos(t4);  // forward and down from the shoulder to the wrist pitch axis
    const double f = -p.z() - wrist_ * std::sin(t4);
    const double elbow_cosine =
        (e * e + f * f - lower_arm_ * lower_arm_ - upper_arm_ * upper_arm_) / (2 * lower_arm_ * upper_arm_);
    if (std::abs(elbow_cosine) > 1 + kStretch) continue;
    const double elbow = std::acos(std::clamp(elbow_cosine, -1.0, 1.0));
    const double t2 = std::remainder(
        std::atan2(f, e) - std::atan2(upper_arm_ * std::sin(elbow), lower_arm_ + upper_arm_ * std::cos(elbow)), 2 * pi);
    JointVector q(6);
    q << q1, t2, elbow - pi / 2, t4 - (t2 + elbow), nearest_turn(std::atan2(sign * sine5, sideways), near[4]),
        std::atan2(flange.linear().col(0).dot(arm.along), flange.linear().col(1).dot(arm.along));
    const double change = (q - near).tail<3>().cwiseAbs().sum();
    if (change < least) {
      least = change;
      best = q;
    }
  }
  if (!std::isfinite(least) || !best.allFinite()) return ErrorCode::out_of_workspace;
  joints = best;
  return rolls_aligned || above_shoulder ? ErrorCode::singular : ErrorCode::none;
}

Jacobian Kinematics::jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept {
  const double q1 = joints[0], t2 = joints[1];
  const double t3 = t2 + joints[2] + pi / 2;
  const double t4 = t3 + joints[3];
  const Pose pose = flange(joints);
  const Vector3d point = pose * offset;
  const Vector3d elbow = lower_arm_ * ArmAxes(q1, t2).along;
  const Vector3d pitch = elbow + upper_arm_ * ArmAxes(q1, t3).along;
  const ArmAxes arm(q1, t4);

  Jacobian j(6, 6);
  const auto column = [&](int i, const Vector3d& axis, const Vector3d& centre) {
    j.col(i) << axis.cross(point - centre), axis;
  };
  column(0, Vector3d::UnitZ(), Vector3d::Zero());
  column(1, arm.side, Vector3d::Zero());
  column(2, arm.side, elbow);
  column(3, arm.side, pitch);
  column(4, arm.along, pitch);
  column(5, pose.linear().col(2), pose.translation());
  return j;
}

}  // namespace mrroc::irb6
