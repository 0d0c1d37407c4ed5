#include "robots/common/kdl_chain.hpp"

#include <urdf_parser/urdf_parser.h>

#include <stdexcept>
#include <vector>

namespace mrroc {
namespace {

KDL::Vector vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

KDL::Frame frame(const urdf::Pose& pose) {
  const auto& r = pose.rotation;
  return {KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w), vector(pose.position)};
}

KDL::RigidBodyInertia inertia(const urdf::Link& link) {
  if (!link.inertial) return KDL::RigidBodyInertia::Zero();
  const auto& i = *link.inertial;
  const KDL::Frame centre = frame(i.origin);
  const KDL::RigidBodyInertia about_centre(i.mass, KDL::Vector::Zero(),
                                           KDL::RotationalInertia(i.ixx, i.iyy, i.izz, i.ixy, i.ixz, i.iyz));
  return centre * about_centre;
}

KDL::Joint joint(const urdf::Joint& j) {
  const KDL::Frame origin = frame(j.parent_to_joint_origin_transform);
  switch (j.type) {
    case urdf::Joint::FIXED:
      return KDL::Joint(j.name, KDL::Joint::None);
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return KDL::Joint(j.name, origin.p, origin.M * vector(j.axis), KDL::Joint::RotAxis);
    case urdf::Joint::PRISMATIC:
      return KDL::Joint(j.name, origin.p, origin.M * vector(j.axis), KDL::Joint::TransAxis);
    default:
      throw std::runtime_error("joint " + j.name + " is neither fixed, revolute, continuous nor prismatic");
  }
}

}  // namespace

Pose pose_of(const KDL::Frame& frame) {
  Pose pose = Pose::Identity();
  pose.translation() << frame.p.x(), frame.p.y(), frame.p.z();
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data);
  return pose;
}

KDL::Chain kdl_chain(const std::filesystem::path& urdf, const std::string& tip) {
  const auto model = urdf::parseURDFFile(urdf.string());
  if (!model) throw std::runtime_error(urdf.string() + " is not a URDF");
  std::vector<urdf::LinkConstSharedPtr> links;
  for (auto link = model->getLink(tip); link && link->parent_joint; link = link->getParent()) links.push_back(link);
  KDL::Chain chain;
  for (auto link = links.rbegin(); link != links.rend(); ++link) {
    const urdf::Joint& parent = *(*link)->parent_joint;
    chain.addSegment(
        KDL::Segment((*link)->name, joint(parent), frame(parent.parent_to_joint_origin_transform), inertia(**link)));
  }
  return chain;
}

}  // namespace mrroc
