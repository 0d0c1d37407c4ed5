#include "bench/kinematics/urdf_chain.hpp"

#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace mrroc::bench {
namespace {

KDL::Vector vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

KDL::Frame frame(const urdf::Pose& pose) {
  const auto& r = pose.rotation;
  return {KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w), vector(pose.position)};
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
      throw std::runtime_error("joint " + j.name + " is of a kind that no robot here has");
  }
}

/// From the root to the tool frame.
std::vector<urdf::JointSharedPtr> joints_to_tool(const urdf::ModelInterface& model) {
  std::vector<urdf::JointSharedPtr> joints;
  for (auto link = model.getLink("tool_frame"); link && link->parent_joint; link = link->getParent())
    joints.push_back(link->parent_joint);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::string difference(const std::vector<urdf::JointSharedPtr>& joints, const RobotParameters& parameters) {
  auto axis = parameters.axes.begin();
  for (const auto& j : joints) {
    if (j->type == urdf::Joint::FIXED) continue;
    if (axis == parameters.axes.end() || axis->name != j->name) return "'" + j->name + "' on the way to the tool";
    ++axis;
  }
  return axis == parameters.axes.end() ? "" : "no '" + axis->name + "' on the way to the tool";
}

}  // namespace

UrdfChain urdf_chain(const std::filesystem::path& file, const RobotParameters& parameters) {
  const auto model = urdf::parseURDFFile(file.string());
  if (!model || !model->getLink("tool_frame")) {
    throw std::runtime_error(file.string() + " is not a URDF with a link 'tool_frame'");
  }
  const auto joints = joints_to_tool(*model);
  UrdfChain result{.chain = {}, .missing = difference(joints, parameters)};
  if (!result.missing.empty()) return result;
  for (auto j = joints.begin(); j != joints.end();) {
    const KDL::Joint moving = joint(**j);
    KDL::Frame tip = frame((*j)->parent_to_joint_origin_transform);
    for (++j; j != joints.end() && (*j)->type == urdf::Joint::FIXED; ++j)
      tip = tip * frame((*j)->parent_to_joint_origin_transform);
    result.chain.addSegment(KDL::Segment(moving, tip));
  }
  return result;
}

}  // namespace mrroc::bench
