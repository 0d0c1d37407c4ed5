#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mrroc/errors.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// The description of a machine's closed loops, which a URDF, a tree, cannot contain.
struct ClosedLoops {
  struct Joint {
    std::string name;
    double position = 0;  ///< rad or m
  };
  std::vector<Joint> joints;                                ///< joints of the URDF that no motor drives
  std::vector<std::pair<std::string, std::string>> joined;  ///< links of the URDF whose frames have the same origin
};

/// Receives the branches of an inverse kinematics one after the other. Real-time safe.
class BranchReceiver {
 public:
  /// Receives one posture; the receiver handles limits and whole turns. `exact` false: its pose is the nearest that the
  /// geometry allows, and the receiver measures the distance.
  virtual void add(const JointVector& joints, bool exact) noexcept = 0;
  /// Whether one of the postures received so far is within the robot's limits, directly or after whole turns.
  virtual bool found() noexcept = 0;

 protected:
  ~BranchReceiver() = default;
};

/// One kinematic model of a robot: motor <-> joint <-> flange pose. Every method is const and may be called from
/// any thread; except `closed_loops` they allocate nothing and never throw, and the servo thread calls them. Poses are
/// of the flange in the robot's base frame; `ToolKinematics` adds the tool.
class RobotModel {
 public:
  virtual ~RobotModel() = default;

  /// The name that deployments and task programs use, unique among the models of its robot, e.g. "calibrated".
  virtual std::string_view name() const noexcept { return "nominal"; }
  /// Axes, limits, gains: the same for every model of a robot.
  virtual const RobotParameters& parameters() const noexcept = 0;
  int joint_count() const noexcept { return static_cast<int>(parameters().axes.size()); }

  /// Motor shafts (rad) to joints. `none`, or `motor_limit` when no joint position belongs to `motors`.
  virtual ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept = 0;
  /// Joints to motor shafts (rad). `none`, or `joint_limit` when the transmission cannot reach `joints`.
  virtual ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept = 0;
  /// G(q) = d motors / d joints, rad/rad or rad/m; motor velocities are G dq/dt, joint torques G^T (motor torques).
  virtual JointMatrix transmission(const JointVector& joints) const noexcept = 0;

  /// The robot's default tool: its frame in the flange frame.
  virtual Pose default_tool() const noexcept { return Pose::Identity(); }
  /// Flange pose of `joints`.
  virtual Pose flange(const JointVector& joints) const noexcept = 0;
  /// Joints of a flange pose on the branch nearest to `near`; inverse(flange(q), q) is q. `none`, `out_of_workspace`,
  /// or `singular` (then `joints` still holds a solution, with the free angle kept from `near`). Joint limits are not
  /// checked.
  virtual ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept = 0;
  /// Every branch of a flange pose, the branch of `inverse` first; the default returns only that one. A free joint
  /// (singular pose, redundant robot) keeps its value of `near`; while no posture is `found()`, its other values
  /// follow.
  virtual void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept {
    JointVector joints = near;
    const ErrorCode code = inverse(flange, near, joints);
    if (code == ErrorCode::none || code == ErrorCode::singular) receiver.add(joints, true);
  }
  /// Name of the branch of `joints`, for messages, e.g. "elbow up, sin q5 >= 0"; empty by default.
  virtual std::string_view branch_name(const JointVector& /*joints*/) const noexcept { return {}; }
  /// The change of a joint that leaves the flange pose unchanged: 2 pi for a revolute joint; the default 0: no such
  /// change.
  virtual double joint_period(int /*joint*/) const noexcept { return 0; }
  /// The joint that `inverse` keeps from `near` where a pose leaves one free; -1: no such joint. A motion of the tool
  /// does not move it: joint velocities that follow a twist are computed from the Jacobian without its column.
  virtual int kept_joint() const noexcept { return -1; }
  /// Geometric Jacobian, in base axes, of a point fixed to the flange: `offset` in flange axes, m.
  virtual Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept = 0;

  /// The closure of the robot's URDF at `joints`; nothing without loops. Configuration time only: the one method that
  /// allocates.
  virtual ClosedLoops closed_loops(const JointVector& /*joints*/) const { return {}; }
};

/// All models of one robot, with the same parameters; the robot starts with the first.
using RobotModels = std::vector<std::shared_ptr<const RobotModel>>;

}  // namespace mrroc
