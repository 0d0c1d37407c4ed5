#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// One of the arms that hold an object together.
struct CooperatingArm {
  Robot* robot = nullptr;
  Pose base = Pose::Identity();  ///< of its base frame in the frame of the path, mostly the world
  /// The wrench that the object exerts on the tool, in tool axes about the tool frame's origin, without the tool's own
  /// weight. Called once per step, must not allocate. Empty: the arms are only moved together.
  std::function<Wrench()> wrench = nullptr;
};

/// Limits of the object's frame.
struct CooperativeLimits {
  double speed = 0.1;                 ///< m/s
  double acceleration = 0.2;          ///< m/s^2
  double angular_speed = 0.2;         ///< rad/s
  double angular_acceleration = 0.4;  ///< rad/s^2
};

/// Control of the internal wrenches, with which the arms work against each other.
struct InternalForce {
  double squeeze = 0;        ///< N, desired: each arm presses with it towards the middle of the grasps; below 0: pulls
  double admittance = 3e-5;  ///< b, m/(N s)
  double length = 0.2;       ///< l, m: torques count as forces at this arm
  double lag = 0.05;         ///< s
  double travel = 0.01;      ///< m: an arm gives way by this at most, and by travel / length rad
  double limit = 60;         ///< N: an arm's internal force beyond this is an error
};

/// Several arms carry one rigid object along a path, all commanded in every step, on one grid.
///
/// The object's frame O moves through the poses of the path without stopping: a cubic spline of position and rotation
/// vector with continuous second derivative (two poses: straight, about one axis), with a jerk-limited speed along it
/// from rest to rest, such that linear and angular speed and acceleration stay within the limits. The tool of arm i is
/// at
///
///   B_i^-1 O(t) X_i D_i(t),   X_i = O(0)^-1 B_i T_i
///
/// with B_i its base and T_i its desired tool pose at the start: the grasps are computed from the poses of the arms at
/// the start, so an error of the grasp causes no force. The tool frame's origin should be where the object is held. The
/// first pose of the path is the object's present pose; a path of that pose alone keeps it there until a condition
/// holds.
///
/// D_i is the displacement by which the arm gives way, so that the internal wrenches keep their desired value. Let h
/// stack the wrenches of the object on the tools, (force, torque / l) about the grasps, and W the grasp matrix, so that
/// W h is the resulting wrench on the object. h = W^+ W h + P h: the first part moves and carries the object; the
/// second, with P = I - W^+ W, only squeezes, pulls or bends it. The columns of W^T are the displacements of the grasps
/// with the object, so P also selects the displacements that do not move the object. The stack d of all (translation, l
/// rotation) of D_i follows
///
///   dd/dt = b (P h - desired),   through a low-pass of time constant `lag`,
///
/// and the force control does not carry the object off its path. The wrenches in P h sum to zero. For two arms its
/// forces are (f_1 - f_2) / 2 along the line of the grasps, as in Uchiyama and Dauchez (ICRA 1988); for n arms it is
/// the null space of the grasp matrix (the virtual linkage of Williams and Khatib, ICRA 1993, is a basis of it). With
/// the pseudo-inverse, carrying an object never makes two arms squeeze it. b k, with k the stiffness of the closed
/// chain of drives and grasps (two IRb-6 and a stiff bar: about 300 kN/m), should be 2 to 10 / s; the macrostep and the
/// low-pass bound it.
///
/// The control runs here and not in the EDPs' force law (ForceControl): an EDP measures only its own wrist and cannot
/// distinguish squeezing from the object's weight, and its force motion has no position to return to.
///
/// Ends on its own at the end of the path, when the arms rest. A pause brings the object to rest on its path, within
/// the limits. After a late command each arm stops on its own. The object is then assumed to be at their mean pose,
/// returns to its path within a second and continues along it.
class CooperativeMotion : public Generator {
 public:
  /// Throws NonFatalError(invalid_argument): no arm, an arm listed twice, some with wrench and some without; no pose, a
  /// pose that is not rigid, equals the previous one or is rotated by more than 3 rad from the first; an invalid limit
  /// or number.
  CooperativeMotion(std::vector<CooperatingArm> arms, const std::vector<Pose>& path,
                    const CooperativeLimits& limits = {}, const InternalForce& internal = {});
  ~CooperativeMotion() override;
  CooperativeMotion(CooperativeMotion&&) noexcept;
  CooperativeMotion& operator=(CooperativeMotion&&) noexcept;

  /// Arms that are still moving come to rest as if they were giving way. Throws NonFatalError: invalid_argument when
  /// their macrosteps differ in length; out_of_workspace, joint_limit, motor_limit, velocity_limit where an arm cannot
  /// follow the object's path.
  void start() override;
  void resume() override;
  bool brake() override;
  bool terminal_condition() override;
  /// Throws NonFatalError: sensor_not_ready (a wrench that is not finite), force_limit (`limit`; an arm would have to
  /// give way by more than `travel`).
  void next_state() override;

  /// Duration of the path, s.
  double duration() const noexcept;
  /// Desired pose of the object at the end of the last step's macrostep, in the frame of the path.
  const Pose& object() const noexcept;
  /// The largest internal force (N) and torque (N m) of any arm at the last step, as measured.
  double internal_force() const noexcept;
  double internal_torque() const noexcept;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mrroc
