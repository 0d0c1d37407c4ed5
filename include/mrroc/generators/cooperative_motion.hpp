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
  /// That the object exerts on the tool, in tool axes about the tool frame's origin, without the tool's own weight.
  /// Called once per step, must not allocate. None: the arms are only moved together.
  std::function<Wrench()> wrench = nullptr;
};

/// Of the object's frame.
struct CooperativeLimits {
  double speed = 0.1;                 ///< m/s
  double acceleration = 0.2;          ///< m/s^2
  double angular_speed = 0.2;         ///< rad/s
  double angular_acceleration = 0.4;  ///< rad/s^2
};

/// How the wrenches with which the arms work against each other are controlled.
struct InternalForce {
  double squeeze = 0;        ///< N, wanted: every arm presses so much towards the middle of the grasps; below 0: pulls
  double admittance = 3e-5;  ///< b, m/(N s)
  double length = 0.2;       ///< l, m: torques count as forces at this arm
  double lag = 0.05;         ///< s
  double travel = 0.01;      ///< m: an arm gives way by so much at most, and by travel / length rad
  double limit = 60;         ///< N: an arm's internal force beyond this is an error
};

/// Several arms carry one rigid object along a path, all commanded in every step, on one grid.
///
/// The object's frame O goes through the poses of the path without stopping: a cubic spline of position and rotation
/// vector with continuous second derivative (two poses: straight, about one axis), and along it a jerk-limited speed
/// from rest to rest, such that speed and acceleration, linear and angular, keep the limits. Arm i has its tool at
///
///   B_i^-1 O(t) X_i D_i(t),   X_i = O(0)^-1 B_i T_i
///
/// with B_i its base and T_i its desired tool pose at the start: how the arms hold the object is taken from how they
/// stand, so an error of the grasp makes no force. The tool frame's origin should be where the object is held. The
/// first pose of the path is where the object is; a path of that pose alone holds it there, until a condition holds.
///
/// D_i is what the arm gives way by, so that the internal wrenches keep their wanted value. Let h stack the wrenches of
/// the object on the tools, (force, torque / l) about the grasps, and W the grasp matrix, W h what all of them do to
/// the object. h = W^+ W h + P h: the first part moves and carries the object; the second, P = I - W^+ W, does nothing
/// to it, the arms squeeze, pull, bend it. The columns of W^T are the displacements of the grasps with the object, so
/// P also takes those in which the object does not move: the stack d of all (translation, l rotation) of D_i follows
///
///   dd/dt = b (P h - wanted),   through a low-pass of time constant `lag`,
///
/// and the force control does not carry the object off its path. P h sums up to no wrench; of two arms its forces are
/// (f_1 - f_2) / 2 along the line of the grasps, Uchiyama and Dauchez's (ICRA 1988); for n arms it is the grasp matrix'
/// null space (Williams and Khatib, ICRA 1993, choose a basis of it: their virtual linkage). The pseudo-inverse lets
/// two arms never squeeze what they carry. b k, with k the stiffness of the closed chain of drives and grasps (two
/// IRb-6 and a stiff bar: about 300 kN/m), should be 2 to 10 / s; the macrostep and the low-pass bound it.
///
/// It is computed here and not by the EDPs' force law (ForceControl): an EDP knows its own wrist only and cannot tell a
/// squeeze from the object's weight, and its motion has no place to come back to.
///
/// Ends on its own when the path does and the arms rest. A pause brings the object to rest on its path, within the
/// limits. After a late command the arms stand where each of them has stopped; the object is taken to be in the middle
/// of that, comes back to its path within a second and continues along it.
class CooperativeMotion : public Generator {
 public:
  /// Throws NonFatalError(invalid_argument): no arm, one twice, some with wrench and some without, no pose, one that is
  /// not rigid, equals the one before or is turned by more than 3 rad from the first; a limit or number that is none.
  CooperativeMotion(std::vector<CooperatingArm> arms, const std::vector<Pose>& path,
                    const CooperativeLimits& limits = {}, const InternalForce& internal = {});
  ~CooperativeMotion() override;
  CooperativeMotion(CooperativeMotion&&) noexcept;
  CooperativeMotion& operator=(CooperativeMotion&&) noexcept;

  /// Arms that still move come to rest as if they were giving way. Throws NonFatalError: invalid_argument when their
  /// macrosteps differ in length; out_of_workspace, joint_limit, motor_limit, velocity_limit where an arm cannot follow
  /// the object's path.
  void start() override;
  void resume() override;
  bool brake() override;
  bool terminal_condition() override;
  /// Throws NonFatalError: sensor_not_ready (a wrench that is not finite), force_limit (`limit`; an arm would have to
  /// give way by more than `travel`).
  void next_state() override;

  /// Of the path, s.
  double duration() const noexcept;
  /// Where the object should be at the end of the last step's macrostep, in the frame of the path.
  const Pose& object() const noexcept;
  /// The largest internal force (N) and torque (N m) of any arm at the last step, as measured.
  double internal_force() const noexcept;
  double internal_torque() const noexcept;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mrroc
