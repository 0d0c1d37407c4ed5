#include "bench/kinematics/kdl_kinematics.hpp"

namespace mrroc::bench {
namespace {

constexpr int kSteps = 100;  // of Newton
constexpr double kError = 1e-5;

KDL::JntArray joint_array(const JointVector& joints) {
  KDL::JntArray array;
  array.data = joints;
  return array;
}

KDL::Frame frame(const Pose& pose) {
  KDL::Frame result;
  for (int row = 0; row < 3; ++row) {
    result.p[row] = pose.translation()[row];
    for (int column = 0; column < 3; ++column) result.M(row, column) = pose.linear()(row, column);
  }
  return result;
}

}  // namespace

KdlKinematics::KdlKinematics(const KDL::Chain& chain)
    : chain_(chain),
      direct_(chain_),
      lma_(chain_),
      velocity_(chain_),
      newton_(chain_, direct_, velocity_, kSteps, kError),
      jacobian_(chain_),
      joints_(chain_.getNrOfJoints()),
      matrix_(chain_.getNrOfJoints()) {}

void KdlKinematics::add(const Posture& posture) {
  postures_.push_back({joint_array(posture.joints), joint_array(posture.near), frame(posture.pose)});
}

void KdlKinematics::remove_last() { postures_.pop_back(); }

Pose KdlKinematics::pose() const {
  Pose result = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    result.translation()[row] = pose_.p[row];
    for (int column = 0; column < 3; ++column) result.linear()(row, column) = pose_.M(row, column);
  }
  return result;
}

}  // namespace mrroc::bench
