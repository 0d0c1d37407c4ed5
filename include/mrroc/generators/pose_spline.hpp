#pragma once

#include <vector>

#include "mrroc/generators/path_generator.hpp"
#include "mrroc/generators/path_limits.hpp"

namespace mrroc {

enum class SplineKind {
  linear,  ///< straight from pose to pose with rotation about one axis, at rest in each
  cubic,   ///< continuous linear and angular acceleration; smallest mean square acceleration
  quintic  ///< also continuous jerk; smallest mean square jerk
};

/// A pose and the time at which the tool reaches it.
struct TimedPose {
  Pose pose = Pose::Identity();
  double time = 0;  ///< s after the start of the path
};

/// The tool moves through poses: a spline from its present pose through all of them, at rest at the start and in the
/// last one.
///
/// The position's spline is the cubic or quintic (C4) one of the textbooks. The orientation follows, from pose i on,
///   R(s) = exp([phi_i(s)]) R_i,
/// with a polynomial of degree five for the rotation vector phi_i that has at both ends the angular velocity and its
/// rate of the knots (through the Jacobian of the exponential map: src/geometry/rotation_rates.hpp), so both are
/// exactly continuous, however far the tool rotates; from knot to knot it rotates by less than pi. The rates at the
/// knots are the derivatives of the spline, cubic or quintic, through the sums of the rotations from knot to knot in
/// base axes. About a fixed axis that is the spline of the angle; in general it is an approximation, and the quintic's
/// angular jerk may step.
///
/// By speed, the parameter is the time from pose to pose at full speed, and the tool moves as fast as the limits allow;
/// the path begins and ends without curvature. By times, the parameter is the time, and velocity and acceleration are 0
/// at the start and the end. `start()` refuses a path that the joints cannot follow: NonFatalError (velocity_limit,
/// acceleration_limit, jerk_limit), with the joint and the missing factor. After an interruption a timed path is late
/// by the time lost; it is not faster than planned.
///
/// See PathGenerator for limits, interruptions, and the start.
class PoseSpline : public PathGenerator {
 public:
  /// By speed. Poses that differ by less than 0.1 mm and 0.1 mrad are merged; the last one is always kept. Throws
  /// NonFatalError(invalid_argument): no pose, a pose that is not rigid, a limit that is not above 0.
  PoseSpline(Robot& robot, const std::vector<Pose>& poses, SplineKind kind = SplineKind::cubic,
             const PathLimits& limits = {});
  /// By times: above 0, ascending. Throws the same, also for other times.
  PoseSpline(Robot& robot, std::vector<TimedPose> poses, SplineKind kind = SplineKind::cubic);

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;

  std::vector<TimedPose> poses_;
  bool timed_;
  SplineKind kind_;
  PathLimits limits_;
};

}  // namespace mrroc
