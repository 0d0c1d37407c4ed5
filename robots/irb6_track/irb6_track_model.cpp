#include "robots/irb6_track/irb6_track_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/robot_files.hpp"
#include "geometry/inverse_tools.hpp"
#include "robots/irb6/geometry_file.hpp"

namespace mrroc {
namespace {

constexpr double kAlongTrack = 1e-6;  // |cos q1|; below it rounding of x would move the track by more than 1e-10 m

/// Joints or motors of the arm alone.
JointVector arm_of(const JointVector& values) { return values.tail<6>(); }

JointVector joined(double track, const JointVector& arm) {
  JointVector values(7);
  values << track, arm;
  return values;
}

}  // namespace

Irb6TrackModel::Irb6TrackModel(std::string name, Keeps keeps, RobotParameters parameters, double track_gear,
                               const irb6::Geometry& arm)
    : name_(std::move(name)),
      keeps_(keeps),
      parameters_(std::move(parameters)),
      track_gear_(track_gear),
      transmission_(arm),
      kinematics_(arm),
      tool_(arm.tool),
      behind_(kinematics_.plane().behind(parameters_, 1)) {}

ErrorCode Irb6TrackModel::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  JointVector arm;
  if (!motors.allFinite() || transmission_.motors_to_joints(arm_of(motors), arm) != ErrorCode::none) {
    return ErrorCode::motor_limit;
  }
  joints = joined((motors[0] - parameters_.axes[0].motor_synchro) / track_gear_, arm);
  return ErrorCode::none;
}

ErrorCode Irb6TrackModel::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  JointVector arm;
  const double track = track_gear_ * joints[0] + parameters_.axes[0].motor_synchro;
  if (!std::isfinite(track) || transmission_.joints_to_motors(arm_of(joints), arm) != ErrorCode::none) {
    return ErrorCode::joint_limit;
  }
  motors = joined(track, arm);
  return ErrorCode::none;
}

JointMatrix Irb6TrackModel::transmission(const JointVector& joints) const noexcept {
  JointMatrix g = JointMatrix::Zero(7, 7);
  g(0, 0) = track_gear_;
  g.bottomRightCorner<6, 6>() = transmission_.matrix(arm_of(joints));
  return g;
}

Pose Irb6TrackModel::flange(const JointVector& joints) const noexcept {
  Pose pose = kinematics_.flange(arm_of(joints));
  pose.translation().y() += joints[0];
  return pose;
}

ErrorCode Irb6TrackModel::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!flange.translation().allFinite() || !near.allFinite()) return ErrorCode::out_of_workspace;
  double track = near[0];
  const double cosine = std::cos(near[1]);
  const bool along_track = keeps_ == Keeps::column && std::abs(cosine) < kAlongTrack;
  if (keeps_ == Keeps::column && !along_track) {
    const double reach = flange.translation().x() / cosine;  // from the column's axis, in the direction of the arm
    if (reach < -kSingular) return ErrorCode::out_of_workspace;
    track = flange.translation().y() - reach * std::sin(near[1]);
  }
  Pose from_column = flange;
  from_column.translation().y() -= track;
  JointVector arm;
  const ErrorCode code = kinematics_.inverse(from_column, arm_of(near), arm);
  if (code == ErrorCode::out_of_workspace) return code;
  joints = joined(track, arm);
  return along_track ? ErrorCode::singular : code;
}

namespace {

/// Postures of the arm at one position of the track.
class OnTrack final : public BranchReceiver {
 public:
  OnTrack(double track, BranchReceiver& robot) noexcept : track_(track), robot_(&robot) {}
  void add(const JointVector& arm, bool exact) noexcept override { robot_->add(joined(track_, arm), exact); }
  bool found() noexcept override { return robot_->found(); }

 private:
  double track_;
  BranchReceiver* robot_;
};

}  // namespace

void Irb6TrackModel::branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept {
  if (!flange.translation().allFinite() || !near.allFinite()) return;
  const auto try_track = [&](double track) {
    Pose from_column = flange;
    from_column.translation().y() -= track;
    OnTrack arm(track, receiver);
    kinematics_.branches(from_column, arm_of(near), behind_, arm);
    return receiver.found();
  };
  if (keeps_ == Keeps::column) {
    JointVector joints = near;
    if (inverse(flange, near, joints) != ErrorCode::out_of_workspace) {
      receiver.add(joints, true);
      if (!receiver.found()) try_track(joints[0]);
    }
  } else {
    try_track(near[0]);
  }
  const AxisParameters& track = parameters_.axes.front();
  const double longest = std::max(near[0] - track.position_min, track.position_max - near[0]);
  for (int i = 1; !receiver.found() && (i - 1) * kTrackStep < longest; ++i)
    for (const double way : {1.0, -1.0})
      try_track(std::clamp(near[0] + way * i * kTrackStep, track.position_min, track.position_max));
}

Jacobian Irb6TrackModel::jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept {
  Jacobian j(6, 7);
  j.col(0) << Eigen::Vector3d::UnitY(), Eigen::Vector3d::Zero();
  j.rightCols<6>() = kinematics_.jacobian(arm_of(joints), offset);
  return j;
}

RobotModels load_irb6_track(const std::filesystem::path& file) {
  using Keeps = Irb6TrackModel::Keeps;
  const auto table = config::Table::load(config::parameter_file("irb6_track", file));
  const auto parameters = irb6::read_parameters(table, 7);
  const auto track = table.table("track");
  const double gear = track.number("gear");
  if (gear == 0) track.fail("gear", "0 is not a gear ratio", "rad of the motor per m, its sign included");
  track.finish();
  RobotModels models;
  const auto add = [&](const std::string& name, Keeps keeps, const irb6::Geometry& arm) {
    models.push_back(std::make_shared<Irb6TrackModel>(name, keeps, parameters, gear, arm));
  };
  for (const auto& [name, arm] : irb6::read_models(table, parameters, 1)) {
    if (models.empty()) {
      add("track_still", Keeps::track, arm);
      add("track_used", Keeps::column, arm);
    } else {
      add(name, Keeps::track, arm);
    }
  }
  table.finish();
  return models;
}

}  // namespace mrroc
