#pragma once

#include <memory>
#include <utility>

#include "mrroc/robot_model.hpp"

namespace mrroc::kinematics {

/// A model that answers as another one, whatever a derived class does not answer itself. Threads as RobotModel.
class DecoratedModel : public RobotModel {
 public:
  explicit DecoratedModel(std::shared_ptr<const RobotModel> model) : model_(std::move(model)) {}

  std::string_view name() const noexcept override { return model_->name(); }
  const RobotParameters& parameters() const noexcept override { return model_->parameters(); }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    return model_->motors_to_joints(motors, joints);
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    return model_->joints_to_motors(joints, motors);
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override { return model_->transmission(joints); }
  Pose default_tool() const noexcept override { return model_->default_tool(); }
  Pose flange(const JointVector& joints) const noexcept override { return model_->flange(joints); }
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override {
    return model_->inverse(flange, near, joints);
  }
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override {
    model_->branches(flange, near, receiver);
  }
  std::string_view branch_name(const JointVector& joints) const noexcept override {
    return model_->branch_name(joints);
  }
  double joint_period(int joint) const noexcept override { return model_->joint_period(joint); }
  int kept_joint() const noexcept override { return model_->kept_joint(); }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override {
    return model_->jacobian(joints, offset);
  }
  ClosedLoops closed_loops(const JointVector& joints) const override { return model_->closed_loops(joints); }

 protected:
  const RobotModel& model() const noexcept { return *model_; }

 private:
  std::shared_ptr<const RobotModel> model_;
};

}  // namespace mrroc::kinematics
