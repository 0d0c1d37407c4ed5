#pragma once

#include <array>

#include "mrroc/generator.hpp"
#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// How the tool follows a hand.
struct Guidance {
  std::array<bool, 6> free{true, true, true, true, true, true};  ///< tool axes that comply; the others stay
  double damping = 200;                                          ///< N s/m: 20 N for 0.1 m/s (the original's)
  double angular_damping = 10;                                   ///< N m s/rad (the original's)
  double mass = 5;                                               ///< kg that the hand feels
  double inertia = 0.1;                                          ///< kg m^2, likewise
  double speed = 0.15;                                           ///< m/s, at most, of the tool frame's origin
  double angular_speed = 0.5;                                    ///< rad/s, likewise
  double force_threshold = 2;     ///< N that do not move it: noise, a zero that has drifted
  double torque_threshold = 0.2;  ///< N m, likewise
  Load load{};                    ///< on the tool, in the tool frame: its weight is no hand
  Eigen::Vector3d gravity = standard_gravity();
};

/// Hand guiding (lead-through): the tool goes where a hand on it pushes or turns it, and stays where it is left. For
/// the linear axes together, and for the turns likewise,
///
///   M dv/dt + D' v = f,    f = F - F min(|F|, threshold) / |F|,    D' = max(D, |f| / speed),
///
/// F being the measured wrench less the load's weight. The law acts in the robot's EDP at every servo tick; threshold,
/// weight and D' are renewed once a step. So v comes up to `speed` at most while the force is steady, and beyond it by
/// df T / M when the force grows by df within a step of T seconds. Joint limits are never passed: close to one the EDP
/// stops the motion and the Move throws NonFatalError(joint_limit), after which it may be led back.
///
/// Keeps on until a condition of `.until(...)` holds. The robot needs `force_sensor` in the deployment; take its zero
/// (`bias_force()`) before. All axes guarded, no velocity: the original's `tff_nose_run`.
class LeadThrough : public Generator {
 public:
  /// Throws NonFatalError(invalid_argument) unless dampings and speeds are above 0, the rest at least 0, and an axis is
  /// free.
  explicit LeadThrough(Robot& robot, const Guidance& guidance = {});

  void next_state() override;

 private:
  Robot* robot_;
  Guidance guidance_;
};

}  // namespace mrroc
