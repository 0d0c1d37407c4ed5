#pragma once

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// How far one pose is from another.
struct PoseDeviation {
  double position = 0;  ///< m
  double rotation = 0;  ///< rad
};

/// A robot's geometry as it is used now: one of its models, wearing one tool. Poses are of the tool frame in the
/// robot's base frame. Allocates nothing, never throws; any thread. Holds the model by reference.
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
  /// Joints of a tool pose on the branch nearest to `near`, whatever the limits; codes as `RobotModel::inverse`. For
  /// paths of the tool, which keep their branch.
  ErrorCode follow(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept {
    return model_->inverse(pose * inverse_tool_, near, joints);
  }
  /// The same; where those joints pass a joint or motor limit, the nearest posture within the limits instead
  /// (language/nearest_posture.hpp gives the distance), if there is one.
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
