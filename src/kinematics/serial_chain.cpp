#include "kinematics/serial_chain.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace mrroc::kinematics {

namespace {

constexpr double kRigid = 1e-9;

bool is_rigid(const Pose& pose) {
  const Eigen::Matrix3d& r = pose.linear();
  return pose.matrix().allFinite() && (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < kRigid &&
         r.determinant() > 0;
}

/// A rotation that takes z to `axis`.
Eigen::Matrix3d to_axis(const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

}  // namespace

SerialChain::SerialChain(const std::vector<ChainJoint>& joints, const Pose& flange)
    : size_(static_cast<int>(joints.size())) {
  if (joints.empty() || joints.size() > kMaxJoints)
    throw std::invalid_argument("a chain of " + std::to_string(joints.size()) + " joints, expected 1 to " +
                                std::to_string(kMaxJoints));
  Eigen::Matrix3d back = Eigen::Matrix3d::Identity();  // from the joint's own frame to that with the axis as z
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const ChainJoint& joint = joints[i];
    if (!is_rigid(joint.frame))
      throw std::invalid_argument("the frame of joint " + std::to_string(i + 1) + " is not a rigid motion");
    if (!joint.axis.allFinite() || std::abs(joint.axis.norm() - 1) > kRigid)
      throw std::invalid_argument("the axis of joint " + std::to_string(i + 1) + " has not unit length");
    const Eigen::Matrix3d turned = to_axis(joint.axis);
    links_[i] = {back * joint.frame.linear() * turned, back * joint.frame.translation(), joint.slides};
    back = turned.transpose();
  }
  if (!is_rigid(flange)) throw std::invalid_argument("the frame of the flange is not a rigid motion");
  flange_ = Eigen::Translation3d(back * flange.translation()) * Pose(back * flange.linear());
}

template <class Visit>
Pose SerialChain::walk(const JointVector& joints, Visit visit) const noexcept {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int i = 0; i < size_; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Link& link = links_[index];
    position.noalias() += rotation * link.translation;
    rotation = (rotation * link.rotation).eval();
    visit(index, position, rotation.col(2));
    if (link.slides) {
      position += joints[i] * rotation.col(2);
      continue;
    }
    const double c = std::cos(joints[i]), s = std::sin(joints[i]);
    const Eigen::Vector3d x = rotation.col(0);
    rotation.col(0) = c * x + s * rotation.col(1);
    rotation.col(1) = c * rotation.col(1) - s * x;
  }
  Pose flange;
  flange.linear().noalias() = rotation * flange_.linear();
  flange.translation() = position + rotation * flange_.translation();
  flange.makeAffine();
  return flange;
}

Pose SerialChain::flange(const JointVector& joints) const noexcept {
  return walk(joints, [](std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&) noexcept {});
}

void SerialChain::compute(const JointVector& joints, Axes& axes) const noexcept {
  axes.flange =
      walk(joints, [&axes](std::size_t i, const Eigen::Vector3d& origin, const Eigen::Vector3d& axis) noexcept {
        axes.origin[i] = origin;
        axes.axis[i] = axis;
      });
}

Jacobian SerialChain::jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept {
  Axes axes;
  compute(joints, axes);
  return jacobian(axes, offset);
}

Jacobian SerialChain::jacobian(const Axes& axes, const Eigen::Vector3d& offset) const noexcept {
  const Eigen::Vector3d point = axes.flange * offset;
  Jacobian jacobian(6, size_);
  for (int i = 0; i < size_; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Eigen::Vector3d& axis = axes.axis[index];
    if (links_[index].slides) {
      jacobian.col(i) << axis, Eigen::Vector3d::Zero();
    } else {
      jacobian.col(i) << axis.cross(point - axes.origin[index]), axis;
    }
  }
  return jacobian;
}

}  // namespace mrroc::kinematics
