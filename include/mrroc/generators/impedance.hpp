#pragma once

#include <functional>

#include "mrroc/force_law.hpp"
#include "mrroc/generator.hpp"
#include "mrroc/load.hpp"
#include "mrroc/moving_frame.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Parameters of the tool's impedance about its set-point, for each axis of the tool frame: x, y, z (m, N), then the
/// rotations about them (rad, N m).
struct ImpedanceParameters {
  ForceLaw::Axes stiffness = (ForceLaw::Axes() << 500, 500, 500, 20, 20, 20).finished();  ///< K, N/m and N m/rad
  ForceLaw::Axes damping = (ForceLaw::Axes() << 100, 100, 100, 5, 5, 5).finished();       ///< D, N s/m and N m s/rad
  ForceLaw::Axes inertia = (ForceLaw::Axes() << 5, 5, 5, 0.2, 0.2, 0.2).finished();       ///< M, kg and kg m^2
  double speed = 0.1;                                                                     ///< m/s, at most
  double angular_speed = 0.3;                                                             ///< rad/s, at most
  Load load{};  ///< on the tool, in the tool frame: its weight is not an external force
  Eigen::Vector3d gravity = standard_gravity();
};

/// The tool behaves like a mass on a spring and a damper between it and a set-point that may move (impedance control):
/// for each of its axes
///
///   M a + D (v - v_d) + K (x - x_d) = F
///
/// F: the wrench of the environment on the tool, x - x_d: the tool's displacement from the set-point, for rotations the
/// rotation vector; all in tool axes. At rest a force F displaces the tool by F / K; with the set-point at a depth d
/// inside a surface it presses with K d. Free oscillation: sqrt(K / M) rad/s, damping ratio D / (2 sqrt(K M)).
///
/// M and D act in the robot's EDP at every servo tick: they are its force law with m = M, b = 1 / D. The spring is
/// computed here once a step and commanded as the law's desired wrench, -(K (x_d - x) + D v_d), for the predicted tool
/// pose in the middle of the coming macrostep. D is increased while the tool would exceed its speed limit. So K / D
/// times the macrostep's duration must be at most kStiffest: stiffer springs need shorter macrosteps.
///
/// On an environment of stiffness k the force settles as docs/explanation/force.md describes for the law, with k + K in
/// place of k. Continues until a condition of `.until(...)` holds. The robot needs `force_sensor` in the deployment.
class Impedance : public Generator {
 public:
  /// The set-point `seconds` after the start of the motion, pauses not counted: pose and twist in the robot's base
  /// frame (its tick is ignored). Called once per step, must not allocate.
  using SetPoint = std::function<MovingFrame(double seconds)>;

  /// About a pose. Throws NonFatalError(invalid_argument) for a pose that is not rigid, stiffnesses or inertias below
  /// 0, dampings or speeds that are not above 0.
  Impedance(Robot& robot, const Pose& pose, const ImpedanceParameters& parameters = {});
  Impedance(Robot& robot, SetPoint set_point, const ImpedanceParameters& parameters = {});

  /// Throws NonFatalError(invalid_argument) when the spring is too stiff for the macrostep.
  void start() override;
  void resume() override;
  void next_state() override;
  /// The spring acts in real time, and its set-point may be a moving frame.
  bool scales_with_speed() const override { return false; }

  /// K (x_d - x) of the step commanded last, in tool axes: the wrench of the spring on the tool.
  const Wrench& spring() const noexcept { return spring_; }

  static constexpr double kStiffest = 0.5;

 private:
  Robot* robot_;
  SetPoint set_point_;
  ImpedanceParameters parameters_;
  double elapsed_ = 0;  // s, at the start of the coming macrostep
  bool first_ = true;   // nothing has been commanded yet
  Wrench spring_ = Wrench::Zero();
};

}  // namespace mrroc
