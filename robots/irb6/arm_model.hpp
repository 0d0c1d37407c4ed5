#pragma once

#include <filesystem>
#include <numbers>
#include <string>
#include <utility>

#include "mrroc/robot_model.hpp"
#include "robots/irb6/geometry_file.hpp"
#include "robots/irb6/transmission.hpp"

namespace mrroc::irb6 {

/// One model of an arm of the IRb-6's family, all in closed form: its transmission, and as `ArmKinematics` the one of
/// its wrist. The base frame is at shoulder height: z up, x forward at joint 1 = 0. `joints_to_motors` and
/// `motors_to_joints` check the range of the transmission, not the limits of `parameters()`. NaN causes an error,
/// never a NaN result: a failed call does not change its outputs.
template <typename ArmKinematics>
class ArmModel final : public RobotModel {
 public:
  /// `geometry` valid as `read_models` checks it, for as many axes as `parameters` has.
  ArmModel(std::string name, RobotParameters parameters, const Geometry& geometry)
      : name_(std::move(name)),
        parameters_(std::move(parameters)),
        transmission_(geometry),
        kinematics_(geometry),
        tool_(geometry.tool),
        behind_(kinematics_.plane().behind(parameters_, 0)) {}

  std::string_view name() const noexcept override { return name_; }
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    return transmission_.motors_to_joints(motors, joints);
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    return transmission_.joints_to_motors(joints, motors);
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override { return transmission_.matrix(joints); }
  Pose default_tool() const noexcept override { return tool_; }
  Pose flange(const JointVector& joints) const noexcept override { return kinematics_.flange(joints); }
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override {
    return kinematics_.inverse(flange, near, joints);
  }
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override {
    kinematics_.branches(flange, near, behind_, receiver);
  }
  std::string_view branch_name(const JointVector& joints) const noexcept override {
    return ArmKinematics::branch_name(joints);
  }
  double joint_period(int) const noexcept override { return 2 * std::numbers::pi; }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override {
    return kinematics_.jacobian(joints, offset);
  }

 private:
  std::string name_;
  RobotParameters parameters_;
  Transmission transmission_;
  ArmKinematics kinematics_;
  Pose tool_;
  double behind_;
};

/// Reads a parameter file of an arm with `axes` axes: "nominal" first, then the file's other models. Throws
/// ConfigurationError. Configuration time only.
template <typename ArmKinematics>
RobotModels load_arm(const std::filesystem::path& file, int axes) {
  const auto table = config::Table::load(file);
  const auto parameters = read_parameters(table, axes);
  RobotModels models;
  for (const auto& [name, geometry] : read_models(table, parameters)) {
    models.push_back(std::make_shared<ArmModel<ArmKinematics>>(name, parameters, geometry));
  }
  table.finish();
  return models;
}

}  // namespace mrroc::irb6
