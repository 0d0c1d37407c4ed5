#pragma once

#include <array>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::kinematics {

/// One joint of a chain: its frame at zero in that of the joint before (of the first one: in the base frame), and its
/// axis there.
struct ChainJoint {
  Pose frame = Pose::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit length
  bool slides = false;                              ///< it moves along the axis (m) instead of about it (rad)
};

/// A chain of 1 to kMaxJoints joints that slide or turn, from the base to the flange, as a URDF describes it. Any
/// thread; only the constructor allocates or throws.
class SerialChain {
 public:
  /// `flange`: in the last joint's frame. Throws std::invalid_argument: no or too many joints, an axis that has not
  /// unit length, a frame that is not a rigid motion.
  SerialChain(const std::vector<ChainJoint>& joints, const Pose& flange);

  int size() const noexcept { return size_; }
  bool slides(int joint) const noexcept { return links_[static_cast<std::size_t>(joint)].slides; }
  /// T(q) = prod_i F_i exp(a_i q_i), times the flange's frame.
  Pose flange(const JointVector& joints) const noexcept;
  /// The flange, and origin and axis of every joint in the base frame.
  struct Axes {
    Pose flange;
    std::array<Eigen::Vector3d, kMaxJoints> origin, axis;
  };
  void compute(const JointVector& joints, Axes& axes) const noexcept;
  /// Geometric Jacobian in base axes of a point fixed to the flange: `offset` in flange axes, m.
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept;
  Jacobian jacobian(const Axes& axes, const Eigen::Vector3d& offset) const noexcept;

 private:
  /// The flange; `visit(joint, origin, axis)` for each joint on the way, in the base frame.
  template <class Visit>
  Pose walk(const JointVector& joints, Visit visit) const noexcept;

  /// A joint whose axis is z: turning is a combination of two columns.
  struct Link {
    Eigen::Matrix3d rotation;
    Eigen::Vector3d translation;
    bool slides = false;
  };
  std::array<Link, kMaxJoints> links_;
  int size_ = 0;
  Pose flange_;
};

}  // namespace mrroc::kinematics
