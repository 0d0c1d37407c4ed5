#pragma once

#include <array>

#include "mrroc/generator.hpp"
#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Parameters of hand guiding.
struct Guidance {
  std::array<bool, 6> free{true, true, true, true, true, true};  ///< tool axes that comply; the others hold
  double damping = 200;                                          ///< N s/m: 20 N for 0.1 m/s (the original's)
  double angular_damping = 10;                                   ///< N m s/rad (the original's)
  double mass = 5;                                               ///< kg, felt by the hand
  double inertia = 0.1;                                          ///< kg m^2, felt by the hand
  double speed = 0.15;                                           ///< m/s, at most, of the tool frame's origin
  double angular_speed = 0.5;                                    ///< rad/s, at most
  double force_threshold = 2;     ///< N, below which the tool does not move: noise, drift
  double torque_threshold = 0.2;  ///< N m, of the same kind
  Load load{};                    ///< on the tool, in the tool frame: its weight is not a hand force
  Eigen::Vector3d gravity = standard_gravity();
};

/// Hand guiding (lead-through): the tool follows a hand that pushes or turns it, and stays where it is released. For
/// the linear axes together, and in the same manner for the rotations,
///
///   M dv/dt + D' v = f,    f = F - F min(|F|, threshold) / |F|,    D' = max(D, |f| / speed),
///
/// where F is the measured wrench without the load's weight. The law acts in the robot's EDP at every servo tick;
/// threshold, weight and D' are updated once a step. So v is at most `speed` while the force is steady, and exceeds it
/// by df T / M when the force grows by df within a step of T seconds. Joint limits are never exceeded: close to one the
/// EDP stops the motion and the Move throws NonFatalError(joint_limit), after which the tool may be led back.
///
/// Continues until a condition of `.until(...)` holds. The robot needs `force_sensor` in the deployment; bias it
/// (`bias_force()`) first. All axes guarded, no velocity: the original's `tff_nose_run`.
class LeadThrough : public Generator {
 public:
  /// Throws NonFatalError(invalid_argument) unless dampings and speeds are above 0, the other values at least 0, and an
  /// axis is free.
  explicit LeadThrough(Robot& robot, const Guidance& guidance = {});

  void next_state() override;
  /// The hand guides the robot.
  bool scales_with_speed() const override { return false; }

 private:
  Robot* robot_;
  Guidance guidance_;
};

}  // namespace mrroc
