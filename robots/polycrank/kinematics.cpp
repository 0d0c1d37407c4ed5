#include "robots/polycrank/kinematics.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/inverse_tools.hpp"
#include "geometry/rigid_motion.hpp"
#include "robots/polycrank/chord.hpp"
#include "robots/polycrank/self_motion.hpp"

namespace mrroc::polycrank {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kAligned = 1e-10;  // |sin g|

// Directions of the elbow group, turned by `f` about the first axis.
struct GroupAxes {
  explicit GroupAxes(double f) : radial(0, std::cos(f), std::sin(f)), side(0, std::sin(f), -std::cos(f)) {}
  Vector3d radial, side;
};

// Three joints about parallel axes: the pair's end at `point`, their sum a multiple of 2 pi from `sum`; the nearer
// bend.
Vector3d nearest_group(const PlanarPair& pair, const Vector2d& point, double sum, const Vector3d& near) {
  const auto bent = [&](double bend) {
    const Vector2d angles = pair.angles(point, bend, near[0]);
    return Vector3d(nearest_angle(angles[0], near[0]), nearest_angle(angles[1], near[1]),
                    nearest_angle(sum - angles[0] - angles[1], near[2]));
  };
  const Vector3d left = bent(1), right = bent(-1);
  return (left - near).squaredNorm() <= (right - near).squaredNorm() ? left : right;
}

// |sin g|
double sine_of_wrist(const Pose& flange) { return std::hypot(flange.linear()(1, 2), flange.linear()(2, 2)); }

}  // namespace

Kinematics::Kinematics(const Geometry& geometry) noexcept
    : shoulder_(geometry.shoulder_cranks[0], geometry.shoulder_cranks[1]),
      elbow_(geometry.elbow_cranks[0], geometry.elbow_cranks[1]),
      offsets_(geometry.offsets),
      forward_(offsets_[0] + offsets_[1] + offsets_[2]),
      aside_(offsets_[3] + offsets_[4] + offsets_[5]) {}

Pose Kinematics::flange(const JointVector& joints) const noexcept {
  const double f = joints[0] + joints[1] + joints[2];
  const double g = joints[3] + joints[4] + joints[5];
  const GroupAxes group(f);
  const Vector2d shoulder = shoulder_.end(joints[0], joints[1]);
  const Vector2d elbow = elbow_.end(joints[3], joints[4]);
  const Vector3d unrolled = std::cos(g) * group.radial + std::sin(g) * Vector3d::UnitX();
  const double c7 = std::cos(joints[6]), s7 = std::sin(joints[6]);
  Pose pose = Pose::Identity();
  pose.linear().col(0) = c7 * unrolled + s7 * group.side;
  pose.linear().col(1) = c7 * group.side - s7 * unrolled;
  pose.linear().col(2) = std::sin(g) * group.radial - std::cos(g) * Vector3d::UnitX();
  pose.translation() = Vector3d(forward_ + elbow.y(), shoulder.x(), shoulder.y()) + elbow.x() * group.radial +
                       aside_ * group.side + offsets_[6] * pose.linear().col(2);
  return pose;
}

ErrorCode Kinematics::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!is_rigid(flange) || !near.allFinite()) return ErrorCode::out_of_workspace;
  // computed within half a revolution, so that many revolutions cost no precision
  const JointVector within_turn = near.unaryExpr([](double angle) { return std::remainder(angle, 2 * pi); });
  JointVector q(kAxes);
  if (!closed_form(flange, within_turn, q)) return ErrorCode::out_of_workspace;
  q.head<6>() = SelfMotion(shoulder_, elbow_, q.head<6>()).nearest(within_turn.head<6>());
  const JointVector result = q + (near - within_turn);
  if (!result.allFinite()) return ErrorCode::out_of_workspace;
  joints = result;
  const bool rolls_aligned = sine_of_wrist(flange) < kAligned;
  return rolls_aligned || elbow_.folds_onto(elbow_.end(q[3], q[4])) ? ErrorCode::singular : ErrorCode::none;
}

bool Kinematics::closed_form(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  const Vector3d axis = flange.linear().col(2);
  const Vector3d wrist = flange.translation() - offsets_[6] * axis;
  const double sine = sine_of_wrist(flange);
  const double near_share = elbow_.end(near[3], near[4]).x();

  double least = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    const double f = sine < kAligned ? near[0] + near[1] + near[2] : std::atan2(sign * axis.z(), sign * axis.y());
    const double g = std::atan2(sign * sine, -axis.x());
    const GroupAxes group(f);
    // the common reach of both pairs
    const Vector3d reach = wrist - aside_ * group.side - forward_ * Vector3d::UnitX();
    const auto shoulder_chord = chord(shoulder_, reach.dot(group.radial), reach.dot(group.side));
    const auto elbow_chord = chord(elbow_, 0, reach.x());
    if (!shoulder_chord || !elbow_chord) continue;
    const auto share = nearest_in_both(*shoulder_chord, *elbow_chord, near_share);
    if (!share) continue;
    const Vector3d unrolled = std::cos(g) * group.radial + std::sin(g) * Vector3d::UnitX();
    const double q7 = std::atan2(flange.linear().col(0).dot(group.side), flange.linear().col(0).dot(unrolled));
    JointVector q(kAxes);
    q << nearest_group(shoulder_, (reach - *share * group.radial).tail<2>(), f, near.segment<3>(0)),
        nearest_group(elbow_, {*share, reach.x()}, g, near.segment<3>(3)), nearest_angle(q7, near[6]);
    const double cost = (q - near).squaredNorm();
    if (cost < least) {
      least = cost;
      joints = q;
    }
  }
  return std::isfinite(least);
}

Jacobian Kinematics::jacobian(const JointVector& joints, const Vector3d& offset) const noexcept {
  const GroupAxes group(joints[0] + joints[1] + joints[2]);
  const Pose pose = flange(joints);
  const Vector3d point = pose * offset;
  // a point on each axis; its position along the axis does not matter
  const auto at_shoulder = [](const Vector2d& p) { return Vector3d(0, p.x(), p.y()); };
  const Vector3d group_start = at_shoulder(shoulder_.end(joints[0], joints[1])) + forward_ * Vector3d::UnitX();
  const auto at_elbow = [&](const Vector2d& p) -> Vector3d {
    return group_start + p.x() * group.radial + p.y() * Vector3d::UnitX();
  };

  Jacobian j(6, kAxes);
  const auto column = [&](int i, const Vector3d& axis, const Vector3d& centre) {
    j.col(i) << axis.cross(point - centre), axis;
  };
  column(0, Vector3d::UnitX(), Vector3d::Zero());
  column(1, Vector3d::UnitX(), at_shoulder(shoulder_.joint(joints[0])));
  column(2, Vector3d::UnitX(), group_start);
  column(3, group.side, group_start);
  column(4, group.side, at_elbow(elbow_.joint(joints[3])));
  column(5, group.side, at_elbow(elbow_.end(joints[3], joints[4])));
  column(6, pose.linear().col(2), pose.translation());
  return j;
}

}  // namespace mrroc::polycrank
