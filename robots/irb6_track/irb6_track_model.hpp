#pragma once

#include <filesystem>
#include <numbers>
#include <string>

#include "mrroc/robot_model.hpp"
#include "robots/irb6/kinematics.hpp"
#include "robots/irb6/transmission.hpp"

namespace mrroc {

/// One model of the IRb-6 on its track, in closed form: joint 0 is the track q0 (m, along the base's y axis), joints
/// 1..6 are those of the arm. The base frame is at the shoulder of the arm at q0 = 0, z up, x forward. A pose has one
/// free joint: the inverse keeps the joint that `Keeps` selects from `near` and solves for the six others. With both,
/// codes and branches are those of the arm (robots/irb6/kinematics.hpp); NaN causes an error, never a NaN result.
class Irb6TrackModel final : public RobotModel {
 public:
  enum class Keeps {
    track,
    /// The arm keeps its direction and the track moves it: q0 = y - x tan q1. `out_of_workspace` when the arm would
    /// have to reach backwards. With the arm along the track (|cos q1| < 1e-6) nothing follows for q0: then the track
    /// is kept and the code is `singular`.
    column,
  };

  /// `parameters` of seven axes, `track_gear` in rad/m; `arm` valid as `irb6::read_models` checks it.
  Irb6TrackModel(std::string name, Keeps keeps, RobotParameters parameters, double track_gear,
                 const irb6::Geometry& arm);

  std::string_view name() const noexcept override { return name_; }
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override;
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override;
  JointMatrix transmission(const JointVector& joints) const noexcept override;
  Pose default_tool() const noexcept override { return tool_; }
  Pose flange(const JointVector& joints) const noexcept override;
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override;
  /// The kept joint at its value of `near`; when that gives no posture within the limits, the track moves from there,
  /// in steps of `kTrackStep`, to the nearest position that gives one.
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override;
  static constexpr double kTrackStep = 0.005;  ///< m
  std::string_view branch_name(const JointVector& joints) const noexcept override {
    return irb6::Kinematics::branch_name(joints.tail<6>());
  }
  double joint_period(int joint) const noexcept override { return joint == 0 ? 0 : 2 * std::numbers::pi; }
  int kept_joint() const noexcept override { return keeps_ == Keeps::track ? 0 : 1; }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override;

 private:
  std::string name_;
  Keeps keeps_;
  RobotParameters parameters_;
  double track_gear_;
  irb6::Transmission transmission_;
  irb6::Kinematics kinematics_;
  Pose tool_;
  double behind_;
};

/// Reads a parameter file of the IRb-6 on its track: "track_still" (the default: keeps the track), "track_used" (keeps
/// the column), then the file's other models, which keep the track. Throws ConfigurationError. Configuration time only.
/// `file` empty: the installed robots/irb6_track/irb6_track.toml.
RobotModels load_irb6_track(const std::filesystem::path& file = {});

}  // namespace mrroc
