#pragma once

#include <memory>

#include "mrroc/coordinated.hpp"
#include "mrroc/force_law.hpp"
#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Parameters of `Complying`, for each axis of the tool frame: x, y, z (m, N), then the rotations about them (rad,
/// N m).
struct Compliance {
  /// b, m/(N s) and rad/(N m s); 0: this axis does not give way.
  ForceLaw::Axes admittance = (ForceLaw::Axes() << 3e-5, 3e-5, 3e-5, 1e-3, 1e-3, 1e-3).finished();
  ForceLaw::Axes stiffness = ForceLaw::Axes::Zero();  ///< K, N/m and N m/rad, of the way back
  Wrench wrench = Wrench::Zero();                     ///< Fd, N and N m: of the environment on the tool, desired
  double lag = 0.05;                                  ///< s
  double acceleration = 0.2;                          ///< m/s^2, at most; the jerk is 10 / s times that
  double angular_acceleration = 1;                    ///< rad/s^2, at most
  double travel = 0.01;                               ///< m, at most
  double turn = 0.05;                                 ///< rad, at most
  Load load{};                                        ///< on the tool, in the tool frame: its weight is subtracted
  Eigen::Vector3d gravity = standard_gravity();
};

/// Compliance of an ECP about the trajectory of its MP, equation (11): the MP commands the pose P (or joints), and this
/// robot goes to P D, where the displacement D gives way to the wrench that the robot's force sensor measures. With x =
/// (translation, rotation vector) of D and F the wrench of the environment on the tool, both in tool axes, without the
/// weight of `load`,
///
///   dx/dt = b (F - Fd - K x),   through a low-pass of time constant `lag`
///
/// (admittance control; Siciliano et al., Robotics, 9.2.2). Against an environment of stiffness k, b (k + K) should be
/// at most 10 / s in macrosteps of 20 ms. Without a stiffness x is kept where the force leaves it. Several arms of one
/// MP's Move that hold one object relieve it so of the forces between them, each by its own sensor, at the
/// step of the Move; CooperativeMotion, in the MP, knows the wrenches of all arms.
///
/// D is without displacement again where the MP's generator plans from the robot's state: at the start of each Move,
/// after a pause, after a late command. While the MP commands `hold` the robot holds. The robot needs `force_sensor` in
/// the deployment.
class Complying : public Coordinated {
 public:
  /// Throws NonFatalError(invalid_argument) for an admittance or stiffness below 0, another number that is not above 0.
  Complying(Superior& superior, Robot& robot, const Compliance& compliance = {});
  ~Complying() override;

  void start() override;
  void resume() override;
  /// Throws NonFatalError: force_limit when it would have to give way by more than `travel` or `turn`;
  /// invalid_argument for a command of the MP that is relative or neither of joints nor a pose.
  void next_state() override;

  /// x at the end of the step commanded last, m and rad.
  ForceLaw::Axes displacement() const noexcept;

 private:
  struct Law;
  std::unique_ptr<Law> law_;
};

}  // namespace mrroc
