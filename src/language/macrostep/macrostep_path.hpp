#pragma once

#include <array>

#include "geometry/desired_state.hpp"
#include "geometry/joint_motion.hpp"
#include "geometry/quintic.hpp"
#include "language/joints/axis_stop.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc {

/// The path of the set-point inside a macrostep of duration D, always as joints. It is planned in one of four spaces:
///
/// - joints: a `Quintic` of the joints.
/// - motors: a `Quintic` m(t) of the shafts; q(t) is its transmission backwards.
/// - task: a `Quintic` of x = (p, phi), the tool's pose being T(t) = (p(t), R0 exp phi(t)); q(t) is its inverse
///   kinematics. Where p is straight in its data, the tool moves straight.
/// - velocity: every joint changes to its velocity v1 in the shortest time under its acceleration and jerk limits and
///   keeps it: an `AxisStop` in a frame that moves with v1.
///
/// In motor and task space velocity and acceleration are central differences of q over +-kDifference of a servo period.
///
/// Allocates nothing, never throws. Refers to the model that it was planned with.
class MacrostepPath {
 public:
  enum class Space : std::uint8_t { joints, motors, task, velocity };

  /// `period`: servo period, s.
  void plan_joints(const DesiredState& from, const DesiredState& to, double duration) noexcept;
  /// Codes of `joints_to_motors`.
  ErrorCode plan_motors(const RobotModel& model, const DesiredState& from, const DesiredState& to, double duration,
                        double period) noexcept;
  /// From the tool's pose at `from` to `to`. `invalid_argument` when the tool would turn by more than kTurnMax.
  ErrorCode plan_task(const ToolKinematics& kinematics, const DesiredState& from, const MovingPose& to, double duration,
                      double period) noexcept;
  void plan_velocity(const RobotParameters& parameters, const DesiredState& from, const JointVector& velocity) noexcept;

  Space space() const noexcept { return space_; }
  /// Of space `joints`.
  const Quintic& quintic() const noexcept { return quintic_; }

  /// State t seconds after the start. `near` are the joints one tick earlier: they choose the branch of the inverse
  /// kinematics. `none`, or the reason why the point has no joint positions (then `state` is undefined).
  ErrorCode at(double t, const JointVector& near, DesiredState& state) const noexcept;

  static constexpr double kDifference = 0.25;  // of a servo period
  static constexpr double kTurnMax = 3.0;      // rad; at pi the direction of rotation is not unique

 private:
  ErrorCode joints_at(double t, const JointVector& near, JointVector& joints) const noexcept;
  Eigen::Matrix<double, 6, 1> coordinates(const Pose& pose) const noexcept;
  DesiredState coordinates(const MovingPose& pose) const noexcept;

  Space space_ = Space::joints;
  Quintic quintic_;
  double difference_ = 0;  ///< s
  const RobotModel* model_ = nullptr;
  Pose inverse_tool_ = Pose::Identity();
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();  ///< R0
  std::array<AxisStop, kMaxJoints> ramps_{};
  JointVector velocity_;  ///< v1
};

}  // namespace mrroc
