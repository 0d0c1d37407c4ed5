#pragma once

#include <memory>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Parameters of surface following.
struct SurfaceContact {
  double admittance = 0.01;         ///< m/(N s), along the tool's z: see docs/explanation/force.md, choosing b
  double inertia = 0.5;             ///< kg, along the tool's z
  double approach_speed = 0.01;     ///< m/s, at most, while the tool touches nothing
  double acceleration = 0.2;        ///< m/s^2, along the surface
  bool turn_to_normal = false;      ///< the tool's z axis is turned against the surface's normal
  double turning_gain = 3;          ///< 1/s
  double angular_speed = 0.3;       ///< rad/s, at most
  double angular_acceleration = 1;  ///< rad/s^2
  Load load{};                      ///< on the tool, in the tool frame: its weight is not contact
  Eigen::Vector3d gravity = standard_gravity();
};

/// Follows an unknown surface: presses along the tool's z axis with a force, and moves along the surface with a
/// velocity in the tool's x-y plane, or along a path. The force law of the robot's EDP controls z at every servo tick
/// (a contact axis); x and y are unguarded.
///
///   velocity   in tool axes; its z component must be 0. Continues until a condition of `.until(...)` holds.
///   path       points in the robot's base frame, joined by straight lines; only their components across the tool's z
///              axis count, the surface determines the rest. With p(s) the point at the length s along them, the tool
///              moves at
///
///                v = dp/ds ds/dt + 4/s (p(s) - x)        without its z component, ds/dt <= speed
///
///              and ends on its own when it is within kTolerance of the last point. The path begins at the first point;
///              the tool moves there along the surface. It does not slow down in corners: when it reverses there it
///              overshoots by v^2 / (2 acceleration) plus the motion of two steps.
///
/// Before contact the tool approaches at `approach_speed`; it moves along the surface only after contact. It approaches
/// again when the force has been below a tenth of the desired one for 10 steps.
///
/// With `turn_to_normal` the tool rotates about its tip, at turning_gain times the angle between its z axis and the
/// surface. Along the path the angle is that of the measured motion, through a low-pass of kSmoothing; across it, where
/// friction does not matter, that of the force: -atan2(F_s, -F_z). The rotation speeds up with angular_acceleration. At
/// a speed v on a radius r it lags by v / r (1 / turning_gain + kSmoothing) rad. A flat tool that aligns on its own
/// needs axes 3 and 4 guarded instead: ForceControl.
///
/// The robot needs `force_sensor` in the deployment. (The original's edge_follow.)
class SurfaceFollowing : public Generator {
 public:
  /// `force` N, above 0. Throws NonFatalError(invalid_argument), also for a velocity with a z component, a path of
  /// fewer than two points or with a repeated point.
  SurfaceFollowing(Robot& robot, double force, const Eigen::Vector3d& velocity, const SurfaceContact& contact = {});
  SurfaceFollowing(Robot& robot, double force, std::vector<Eigen::Vector3d> path, double speed,
                   const SurfaceContact& contact = {});

  void start() override;
  void resume() override;
  bool terminal_condition() override;
  void next_state() override;

  /// m along the path so far, of `length()`; 0 without a path.
  double way() const noexcept { return way_; }
  double length() const noexcept { return ways_.empty() ? 0 : ways_.back(); }

  static constexpr double kTolerance = 5e-4;  ///< m
  static constexpr double kSmoothing = 0.2;   ///< s

 private:
  SurfaceFollowing(Robot& robot, double force, double speed, const SurfaceContact& contact);
  void update_contact(double pressed);
  double approach_force() const;
  Eigen::Vector3d along_path();
  Eigen::Vector3d point_at(double way, Eigen::Vector3d& direction) const;
  Eigen::Vector3d turning(const Wrench& felt) const;

  Robot* robot_;
  double force_;
  double speed_;
  SurfaceContact contact_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< in tool axes; of a path: not used
  std::vector<Eigen::Vector3d> path_;                   ///< base frame
  std::vector<double> ways_;                            ///< to each point along the path, m
  double way_ = 0;                                      ///< s
  double way_speed_ = 0;                                ///< ds/dt
  bool touching_ = false;
  int lost_ = 0;                                            ///< consecutive steps with almost no force
  Eigen::Vector3d commanded_ = Eigen::Vector3d::Zero();     ///< along the surface, tool axes
  Eigen::Vector3d before_ = Eigen::Vector3d::Zero();        ///< the measured position of the previous step, base frame
  Eigen::Vector3d displacement_ = Eigen::Vector3d::Zero();  ///< from there, smoothed, tool axes
  Eigen::Vector3d turned_ = Eigen::Vector3d::Zero();        ///< angular velocity commanded, tool axes
};

}  // namespace mrroc
