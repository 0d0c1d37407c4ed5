#pragma once

#include <ruckig/ruckig.hpp>
#include <vector>

#include "mrroc/generators/cooperative_motion.hpp"

namespace mrroc {

/// A frame's path through poses, from rest to rest. Its coordinates x = (p, phi), with the rotation R_0 exp(phi), are a
/// natural cubic spline x(u) with the poses at its knots, without those that coincide with another (near_places.hpp);
/// the distance of neighbouring knots is the time between them at full speed. u(t) is jerk-limited (Ruckig; the jerk is
/// 10 / s times the acceleration), with
///
///   |x'| du/dt <= speed,   |x'| d2u/dt2 + |x''| (du/dt)^2 <= acceleration
///
/// for position and rotation each, with the largest |x'|, |x''| of the whole spline. Task's thread; `at` and `stop`
/// allocate nothing.
class ObjectPath {
 public:
  /// Throws NonFatalError(invalid_argument): no pose, one that is not rigid, equals the previous one or is rotated by
  /// more than 3 rad from the first; a limit that is not above 0.
  ObjectPath(const std::vector<Pose>& poses, const CooperativeLimits& limits);

  /// s; 0 of a single pose.
  double duration() const noexcept { return knots_.size() > 1 ? trajectory_.get_duration() : 0; }
  /// The frame `t` s after the start; before the start the first pose, after the end the last one.
  Pose at(double t) const noexcept { return pose(parameter(t)); }

  /// Replaces the motion by the shortest stop within the limits from the point of `t`.
  void stop(double t) noexcept;
  /// Replaces the motion by one to the end from rest at the point nearest to `pose`, searched up to `ahead` s at full
  /// speed beyond the point of `t`. Returns that point.
  Pose restart(double t, const Pose& pose, double ahead);

 private:
  using Coordinates = Eigen::Matrix<double, 6, 1>;
  double parameter(double t) const noexcept;
  Coordinates coordinates(double u) const noexcept;
  Pose pose(double u) const noexcept;
  void interpolate();
  void choose_speed(const CooperativeLimits& limits);
  void plan(double from);

  Eigen::Matrix3d first_ = Eigen::Matrix3d::Identity();  // R_0
  std::vector<double> knots_;
  std::vector<Coordinates> values_, curvatures_;  // x and x'' at the knots
  ruckig::InputParameter<1> input_;
  ruckig::Trajectory<1> trajectory_;
};

}  // namespace mrroc
