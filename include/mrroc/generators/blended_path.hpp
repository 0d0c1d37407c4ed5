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

/// Straight lines between poses, each corner rounded off: at most `radius` before it the tool leaves the line and comes
/// to the next line as far behind it, without stopping.
///
/// In a blend, of the duration 2 h at full speed, the velocity goes over from the one line's to the other's by the
/// smooth step u^2 (3 - 2u): between lines of full linear speed v the position is
///   p(u) = corner + v h ((2u^3 - u^4) e_out - (2w^3 - w^4) e_in),   u of 0..1,   w = 1 - u,
/// which passes the corner at 3/16 radius |e_out - e_in|. The orientation goes over likewise, as one polynomial for its
/// rotation vector (src/geometry/pose_path.hpp). So linear AND angular velocity and acceleration are continuous
/// everywhere (those of KDL's Path_RoundedComposite are not). Blends begin at the middle of a line at the latest; the
/// one of a line on which the tool only turns begins there. A line that goes straight back is turned round in
/// before the corner.
///
/// Corners of less than 0.1 mm and 0.1 mrad distance are one, with the smaller radius. A line shorter than half of the
/// radii at its ends, on which the tool turns by less than 20 mrad, is part of one blend, from the line before it to
/// the line behind it. A radius below 0.1 mm counts as 0, and as no corner where the line goes straight on.
///
/// The speed is that of the limits, on lines and in blends, where acceleration, jerk and the joints allow it: in a
/// corner of a right angle at least 0.93 of it when radius >= 5 speed^2 / acceleration; else it is slower there.
///
/// See PathGenerator for limits, interruptions, and the start.
class BlendedPath : public PathGenerator {
 public:
  /// From where the tool is through `points`; the last one's radius has
  /// no meaning. Throws NonFatalError(invalid_argument): no point, a pose that is not rigid, a radius that is negative
  /// or not finite, a limit that is not above 0.
  BlendedPath(Robot& robot, std::vector<BlendPoint> points, const PathLimits& limits = {});

 private:
  std::unique_ptr<RobotPath> path_from(const JointVector& joints) override;
  /// The corners, from `start` on, without what is one place with another corner or with a line.
  std::vector<BlendPoint> corners_from(const Pose& start) const;

  std::vector<BlendPoint> points_;
  PathLimits limits_;
};

}  // namespace mrroc
