#pragma once

#include <vector>

#include "mrroc/generators/path_generator.hpp"
#include "mrroc/generators/path_limits.hpp"

namespace mrroc {

/// A corner of a path.
struct BlendPoint {
  Pose pose = Pose::Identity();
  double radius = 0;  ///< m; 0: the tool stops there
};

/// Straight lines between poses with rounded corners. The tool leaves a line at most `radius` before its corner and
/// joins the next line at the same distance behind the corner, without stopping.
///
/// In a blend, of duration 2 h at full speed, the velocity changes from one line's to the other's by the smooth step
/// u^2 (3 - 2u): between lines of full linear speed v the position is
///   p(u) = corner + v h ((2u^3 - u^4) e_out - (2w^3 - w^4) e_in),   u of 0..1,   w = 1 - u,
/// which passes the corner at 3/16 radius |e_out - e_in|. The orientation follows one polynomial for its rotation
/// vector (src/geometry/pose_path.hpp). So linear AND angular velocity and acceleration are continuous everywhere
/// (those of KDL's Path_RoundedComposite are not). A blend uses at most half of a line; on a line on which the tool
/// only rotates it uses exactly half. Where a line leads straight back, the tool reverses before the corner.
///
/// Corners closer than 0.1 mm and 0.1 mrad are merged into one, with the smaller radius. A line shorter than half of
/// the radii at its ends, on which the tool rotates by less than 20 mrad, becomes part of one blend from the line
/// before it to the line behind it. A radius below 0.1 mm counts as 0, and where the line continues straight such a
/// corner is dropped.
///
/// On lines and in blends the tool moves at the speed limit where acceleration, jerk and the joints allow it. In a
/// right-angled corner the speed is at least 0.93 of the limit when radius >= 5 speed^2 / acceleration; otherwise it is
/// lower.
///
/// See PathGenerator for limits, interruptions, and the start.
class BlendedPath : public PathGenerator {
 public:
  /// From the tool's pose through `points`; the radius of the last point is ignored. Throws
  /// NonFatalError(invalid_argument): no point, a pose that is not rigid, a radius that is negative or not finite, a
  /// limit that is not above 0.
  BlendedPath(Robot& robot, std::vector<BlendPoint> points, const PathLimits& limits = {});

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;
  /// The corners from `start` on, without those that coincide with another corner or lie on a line.
  std::vector<BlendPoint> corners_from(const Pose& start) const;

  std::vector<BlendPoint> points_;
  PathLimits limits_;
};

}  // namespace mrroc
