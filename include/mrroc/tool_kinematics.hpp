#pragma once

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// The distance between two poses.
struct PoseDeviation {
  double position = 0;  ///< m
  double rotation = 0;  ///< rad
};

/// A robot's geometry in use: one of its models with one tool. Poses are of the tool frame in the robot's base frame.
/// Allocates nothing, never throws; any thread. Holds the model by reference.
class ToolKinematics {
 public:
  /// `tool`: the tool frame in the flange frame.
  ToolKinematics(const RobotModel& model, const Pose& tool) noexcept
      : model_(&model), tool_(tool), inverse_tool_(tool.inverse()) {}
  explicit ToolKinematics(const RobotModel& model) noexcept : ToolKinematics(model, model.default_tool()) {}

  const RobotModel& model() const noexcept { return *model_; }
  const Pose& tool() const noexcept { return tool_; }

  /// flange(joints) * tool.
  Pose direct(const JointVector& joints) const noexcept { return model_->flange(joints) * tool_; }
  /// Joints of a tool pose on the branch nearest to `near`, ignoring the limits; codes as `RobotModel::inverse`. For
  /// paths of the tool, which keep their branch.
  ErrorCode follow(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept {
    return model_->inverse(pose * inverse_tool_, near, joints);
  }
  /// The same; where those joints exceed a joint or motor limit, the nearest posture within the limits instead, if one
  /// exists (language/nearest_posture.hpp defines the distance).
  ErrorCode inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept;
  /// Every branch of a tool pose, as `RobotModel::branches`.
  void branches(const Pose& pose, const JointVector& near, BranchReceiver& receiver) const noexcept {
    model_->branches(pose * inverse_tool_, near, receiver);
  }
  /// Geometric Jacobian of the tool frame's origin in base axes.
  Jacobian jacobian(const JointVector& joints) const noexcept { return model_->jacobian(joints, tool_.translation()); }

 private:
  const RobotModel* model_;
  Pose tool_;
  Pose inverse_tool_;
};

}  // namespace mrroc
