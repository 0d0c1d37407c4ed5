#pragma once

#include <string>
#include <string_view>

#include "kinematics/closed_form.hpp"
#include "kinematics/newton.hpp"
#include "kinematics/serial_chain.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::kinematics {

/// The model of an arm that is a serial chain: one motor for each axis, which turns `gear` times as far (rad/rad or
/// rad/m). The inverse is in closed form where the structure has one, else numeric: damped least squares from the
/// given posture, then from the postures of a similar arm that has a closed form, then from random postures within the
/// limits, always the same. A redundant arm (more than six axes)
/// moves its axes as little as possible. Arms with fewer than six axes reach the poses that they can reach exactly.
class ChainModel final : public RobotModel {
 public:
  static constexpr double kTolerance = 1e-9;    ///< m and rad: a posture whose flange is so near reaches the pose
  static constexpr int kIterations = 80;        ///< of the numeric search from the given posture
  static constexpr int kSearches = 480;         ///< from random postures, until one is within the limits
  static constexpr int kSearchIterations = 20;  ///< of each of them: most of those that arrive take fewer than ten

  /// `gear`: one number for each axis. Throws std::invalid_argument: the numbers of axes differ, a gear of zero.
  ChainModel(std::string name, RobotParameters parameters, const SerialChain& chain, const JointVector& gear);

  std::string_view name() const noexcept override { return name_; }
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override;
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override;
  JointMatrix transmission(const JointVector& joints) const noexcept override;
  Pose flange(const JointVector& joints) const noexcept override { return chain_.flange(joints); }
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override;
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override;
  double joint_period(int joint) const noexcept override;
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override {
    return chain_.jacobian(joints, offset);
  }

  const ClosedForm& closed_form() const noexcept { return closed_form_; }

 private:
  /// The revolution of every turning joint that is nearest to `near`.
  void unwrap(const JointVector& near, JointVector& joints) const noexcept;
  ErrorCode closed_inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;
  ErrorCode numeric_inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept;
  bool is_singular(const JointVector& joints) const noexcept;
  void search(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept;

  std::string name_;
  RobotParameters parameters_;
  SerialChain chain_;
  ClosedForm closed_form_;
  ClosedForm similar_;  ///< where the structure has no closed form
  JointVector gear_;
  JointRange range_;
};

}  // namespace mrroc::kinematics
