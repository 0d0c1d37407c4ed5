#pragma once

#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <kdl/chain.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc {

/// KDL's chain of a URDF whose joints are fixed or slides, from its root link to `tip`.
inline KDL::Chain sliding_chain(const std::filesystem::path& file, const std::string& tip) {
  const auto model = urdf::parseURDFFile(file.string());
  if (!model) throw std::runtime_error(file.string() + " is no URDF");
  std::vector<urdf::JointConstSharedPtr> joints;
  for (auto link = model->getLink(tip); link && link->parent_joint; link = link->getParent()) {
    joints.push_back(link->parent_joint);
  }
  KDL::Chain chain;
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
    const urdf::Pose& pose = (*joint)->parent_to_joint_origin_transform;
    const KDL::Frame origin(
        KDL::Rotation::Quaternion(pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w),
        KDL::Vector(pose.position.x, pose.position.y, pose.position.z));
    const KDL::Vector axis((*joint)->axis.x, (*joint)->axis.y, (*joint)->axis.z);
    const bool slides = (*joint)->type == urdf::Joint::PRISMATIC;
    if (!slides && (*joint)->type != urdf::Joint::FIXED) throw std::runtime_error((*joint)->name + " turns");
    chain.addSegment(slides ? KDL::Segment(KDL::Joint(origin.p, origin.M * axis, KDL::Joint::TransAxis), origin)
                            : KDL::Segment(KDL::Joint(KDL::Joint::None), origin));
  }
  return chain;
}

/// Largest difference of an element of the two.
inline double difference(const KDL::Frame& frame, const Pose& pose) {
  double worst = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      worst = std::max(worst, std::abs(frame(row, column) - pose(row, column)));
    }
  }
  return worst;
}

}  // namespace mrroc
