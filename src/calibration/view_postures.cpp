#include "calibration/view_postures.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/postures.hpp"

namespace mrroc::calibration {

namespace {

constexpr double kOffCentre = 0.1;  // of the distance
constexpr double kApproach = 0.01;  // rad or m: more than the play of any gear
constexpr int kCandidates = 400;
constexpr double kGoldenAngle = 2.399963;  // rad: directions that fill a disc evenly

/// The camera frame in the marker frame, candidate k: view 0 is that of `first`.
Pose view(const Pose& first, const ViewCap& cap, int k) {
  const double part = std::sqrt((k % 25 + 0.5) / 25), direction = kGoldenAngle * k;
  const double distance = first.translation().norm() * (cap.nearest + (cap.farthest - cap.nearest) / 4 * (k % 5));
  const Eigen::Vector3d axis(std::cos(direction), std::sin(direction), 0);  // across the view
  const double turn = cap.turn * (k % 3 - 1);
  // about the marker's middle: the camera stays turned to it
  Pose moved = first.inverse();  // the marker in the camera frame
  moved = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * moved;
  const Eigen::Matrix3d tilted = Eigen::AngleAxisd(cap.tilt * part, axis).toRotationMatrix() * moved.linear();
  moved.linear() = tilted;
  moved.translation() = distance * Eigen::Vector3d(kOffCentre * std::cos(3.0 * k), kOffCentre * std::sin(2.0 * k), 1);
  return moved.inverse();
}

}  // namespace

JointVector beside_posture(const JointVector& posture, int approach) { return posture.array() - approach * kApproach; }

bool within_limits(const RobotModel& model, const JointVector& joints) {
  JointVector motors = joints;
  if (model.joints_to_motors(joints, motors) != ErrorCode::none) return false;
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
    if (joints[i] < axis.position_min + kMargin || joints[i] > axis.position_max - kMargin) return false;
    if (axis.motor_min < axis.motor_max && (motors[i] < axis.motor_min || motors[i] > axis.motor_max)) return false;
  }
  return true;
}

namespace {

bool may_be_approached(const RobotModel& model, const JointVector& posture) {
  return within_limits(model, posture) && within_limits(model, beside_posture(posture, 1)) &&
         within_limits(model, beside_posture(posture, -1));
}

}  // namespace

std::vector<JointVector> view_postures(const RobotModel& model, const HandEyeFit& rough, const JointVector& near,
                                       std::size_t count, const ViewCap& cap) {
  const bool moves = rough.carried == Carried::camera;
  const Pose flange_near = model.flange(near);
  const Pose first = rough.marker.inverse() * (moves ? flange_near : flange_near.inverse()) * rough.camera;
  std::vector<JointVector> postures;
  for (int k = 0; k < kCandidates && postures.size() < count; ++k) {
    const Pose carrier = rough.marker * view(first, cap, k) * rough.camera.inverse();
    const Pose flange = moves ? carrier : carrier.inverse();
    JointVector joints = near;
    if (model.inverse(flange, near, joints) != ErrorCode::none) continue;
    if ((joints - near).cwiseAbs().maxCoeff() > cap.joint_reach || !may_be_approached(model, joints)) continue;
    postures.push_back(joints);
  }
  return postures;
}

std::vector<JointVector> first_postures(const RobotModel& model, const JointVector& near, double reach) {
  std::vector<JointVector> postures;
  for (Eigen::Index i = std::max<Eigen::Index>(0, near.size() - 3); i < near.size(); ++i) {
    for (const double side : {1.0, -1.0}) {
      JointVector joints = near;
      joints[i] += side * reach;
      if (may_be_approached(model, joints)) postures.push_back(joints);
    }
  }
  return postures;
}

}  // namespace mrroc::calibration
