#pragma once

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <vector>

#include "edp/force/force_motion.hpp"

namespace mrroc::edp {

/// A singular posture of a robot, and a joint that leads out of it.
struct SingularPosture {
  JointVector joints;
  int joint = 0;
  double way = 1;  ///< direction of the joint with more range, 1 or -1

  JointVector at(double distance) const {
    JointVector posture = joints;
    posture[joint] += way * distance;
    return posture;
  }
};

/// Of the directions that the joints can move the tool in; as large as any where there is only one.
inline double least_singular_value(const RobotModel& model, const JointVector& joints) {
  Jacobian jacobian = ToolKinematics(model).jacobian(joints);
  int count = model.joint_count();
  if (const int kept = model.kept_joint(); kept >= 0) {
    jacobian.col(kept).setZero();
    --count;
  }
  return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues()[std::min(count, 6) - 1];
}

/// Singular postures that one joint alone reaches from `from`, within its limits and two turns; the nearest one per
/// joint.
inline std::vector<SingularPosture> singular_postures(const RobotModel& model, const JointVector& from) {
  constexpr double kStep = 0.01;
  std::vector<SingularPosture> found;
  for (int joint = 0; joint < model.joint_count(); ++joint) {
    const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(joint)];
    const double low = std::max(axis.position_min, from[joint] - 12),
                 high = std::min(axis.position_max, from[joint] + 12);
    const auto value = [&](double position) {
      JointVector joints = from;
      joints[joint] = position;
      return least_singular_value(model, joints);
    };
    double nearest = INFINITY;
    for (double position = low + kStep; position < high - kStep; position += kStep) {
      if (value(position) > std::min(value(position - kStep), value(position + kStep))) continue;
      double a = position - kStep, b = position + kStep;  // least between them
      for (int i = 0; i < 60; ++i) {
        const double third = (b - a) / 3;
        (value(a + third) < value(b - third) ? b : a) += (value(a + third) < value(b - third) ? -third : third);
      }
      const double least = (a + b) / 2;
      if (value(least) < 1e-6 && std::abs(least - from[joint]) < std::abs(nearest - from[joint])) nearest = least;
    }
    if (!std::isfinite(nearest)) continue;
    SingularPosture singular{from, joint, high - nearest > nearest - low ? 1.0 : -1.0};
    singular.joints[joint] = nearest;
    found.push_back(singular);
  }
  return found;
}

/// A motion in free space under a force law that applies a force along one tool axis and is compliant along the others.
struct Pressing {
  double way = 0;        ///< path of the tool along the initial contact axis, m
  double speed = 0;      ///< of the fastest joint, as a part of its limit
  double lost = 0;       ///< largest reported value
  double mean_lost = 0;  ///< mean over all ticks
  ErrorCode ended = ErrorCode::none;
};

/// With `newtons` of the environment on the tool, along axis 1..6 of the tool (`axis` from 0), for `ticks` periods of 2
/// ms.
inline Pressing press(const RobotModel& model, const JointVector& posture, int axis, double newtons, int ticks = 250) {
  constexpr double kTime = 0.002;
  ForceTarget target;
  target.tool = model.default_tool();
  for (int i = 0; i < 6; ++i) target.law.guarded(i);
  target.law.contact(axis, newtons);
  ForceMotion motion(model, kTime);
  DesiredState desired = DesiredState::resting_at(posture);
  motion.start(desired, target.tool);
  const ToolKinematics kinematics(model, target.tool);
  const Pose before = kinematics.direct(posture);
  Pressing result;
  for (int i = 0; i < ticks; ++i) {
    const JointVector last = desired.position;
    const ErrorReport report = motion.step(target, Wrench::Zero(), target.tool, kTime, desired);
    if (report.error_class != ErrorClass::none) {
      result.ended = report.code;
      break;
    }
    result.lost = std::max(result.lost, motion.lost());
    result.mean_lost += motion.lost() / ticks;
    for (Eigen::Index j = 0; j < posture.size(); ++j)
      result.speed = std::max(result.speed, std::abs(desired.position[j] - last[j]) / kTime /
                                                model.parameters().axes[static_cast<std::size_t>(j)].velocity_max);
  }
  const Pose after = kinematics.direct(desired.position);
  if (axis < 3)
    result.way = before.linear().col(axis).dot(after.translation() - before.translation());
  else
    result.way = before.linear().col(axis - 3).dot([&] {
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(after.linear() * before.linear().transpose()));
      return Eigen::Vector3d(turn.angle() * turn.axis());
    }());
  return result;
}

}  // namespace mrroc::edp
