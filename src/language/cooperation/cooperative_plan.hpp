#pragma once

#include <vector>

#include "language/cooperation/internal_wrench.hpp"
#include "language/cooperation/object_path.hpp"
#include "mrroc/generators/cooperative_motion.hpp"

namespace mrroc {

/// The state of a CooperativeMotion from step to step: the path of the object, the grasps of the arms, and the
/// displacements by which they give way. Times t are in s after the start of the coming macrostep. Task's thread;
/// allocates in `start` and `resume` only.
class CooperativePlan {
 public:
  CooperativePlan(std::vector<CooperatingArm> arms, const std::vector<Pose>& poses, const CooperativeLimits& limits,
                  const InternalForce& force);

  /// Computes the grasps from the tools' poses. Throws NonFatalError as CooperativeMotion::start.
  void start();
  /// Continues from the poses at which the arms have stopped.
  void resume();
  /// Brings the object to rest on the path.
  void brake();
  /// Takes the wrenches. Throws as CooperativeMotion::next_state.
  void measure();
  /// Chooses the jerk of the coming macrostep.
  void give_way();
  /// Commands arm `i` for the coming macrostep.
  void command(std::size_t i) const;
  /// Call at the end of that macrostep.
  void advance();

  /// The object is at the end of its path and the arms rest.
  bool ended() const { return !braking_ && over(0) && speed_.isZero(0); }
  std::size_t size() const noexcept { return arms_.size(); }
  double duration() const noexcept { return path_.duration(); }
  const Pose& object() const noexcept { return object_; }
  /// The largest of any arm: N, N m.
  double internal_force() const noexcept;
  double internal_torque() const noexcept;

 private:
  /// O(t).
  Pose object_at(double t) const;
  /// X_i D_i(t), D_i about the grasp, in the object's axes.
  Pose grasp_at(std::size_t arm, double t) const;
  Pose tool_at(std::size_t arm, double t) const;
  bool over(double t) const;
  void check_limits() const;
  /// Throws NonFatalError where arm `i` cannot follow the object's path without giving way: out_of_workspace,
  /// joint_limit, motor_limit, velocity_limit; the error with which its EDP would refuse the motion (MotionCheck).
  void check_arm(std::size_t i) const;
  /// d of arms that still move: they are giving way.
  void take_motion(std::size_t arm);
  /// The part of arm `i` in a stack.
  static auto of(Eigen::VectorXd& stack, std::size_t arm) {
    return stack.segment<6>(static_cast<Eigen::Index>(6 * arm));
  }
  static auto of(const Eigen::VectorXd& stack, std::size_t arm) {
    return stack.segment<6>(static_cast<Eigen::Index>(6 * arm));
  }

  std::vector<CooperatingArm> arms_;
  std::vector<Pose> poses_;
  CooperativeLimits limits_;
  InternalForce force_;

  double step_ = 0;  // of a macrostep, s
  ObjectPath path_;
  double time_ = 0;            // since the path's start, at the start of the coming macrostep
  double clock_ = 0;           // since start or resume, at the same instant
  bool braking_ = false;       // the path ends where the object can come to rest
  Twist off_ = Twist::Zero();  // of the object from its path when it was resumed: translation, rotation vector
  Pose object_ = Pose::Identity();

  std::vector<Pose> grasps_;  // X_i
  InternalWrench internal_;
  Eigen::VectorXd wanted_, measured_, excess_;  // h: wanted P h, h, P h
  // d of all arms, its derivatives at the start of the coming macrostep; the third in it
  Eigen::VectorXd given_, speed_, rate_, jerk_;
};

}  // namespace mrroc
