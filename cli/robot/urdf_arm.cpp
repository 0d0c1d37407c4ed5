#include "cli/robot/urdf_arm.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "core/nearest_word.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::cli {

namespace {

using config::ConfigurationError;
using config::in_quotes;
using edp::Urdf;

std::string root_of(const Urdf& urdf) {
  std::string link = urdf.links().front();
  while (const Urdf::Joint* above = urdf.joint_above(link)) link = above->parent;
  return link;
}

void check_link(const Urdf& urdf, const char* option, const std::string& name) {
  if (urdf.has_link(name)) return;
  const std::string nearest = core::nearest_word(name, urdf.links());
  throw ConfigurationError(
      urdf.file(), 0, option, "no link " + in_quotes(name),
      nearest.empty() ? "one of " + config::alternatives(urdf.links()) : "perhaps " + in_quotes(nearest));
}

/// The joints from the base to the link; empty when it is not on the base.
std::vector<const Urdf::Joint*> path_to(const Urdf& urdf, const std::string& base, const std::string& link) {
  std::vector<const Urdf::Joint*> path;
  std::string at = link;
  while (at != base) {
    const Urdf::Joint* const above = urdf.joint_above(at);
    if (above == nullptr) return {};
    path.push_back(above);
    at = above->parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::size_t axes_in(const std::vector<const Urdf::Joint*>& path) {
  return static_cast<std::size_t>(std::count_if(path.begin(), path.end(), [](const Urdf::Joint* joint) {
    return joint->type != Urdf::Type::fixed && !joint->mimic;
  }));
}

/// The link without children at the end of the most axes. The fingers of a gripper would be several.
std::string end_of(const Urdf& urdf, const std::string& base) {
  std::set<std::string> ends;
  for (const std::string& link : urdf.links()) ends.insert(link);
  for (const std::string& link : urdf.links())
    if (const Urdf::Joint* above = urdf.joint_above(link)) ends.erase(above->parent);
  std::map<std::size_t, std::vector<std::string>> by_axes;
  for (const std::string& link : ends) by_axes[axes_in(path_to(urdf, base, link))].push_back(link);
  const auto& [axes, longest] = *by_axes.rbegin();
  if (longest.size() == 1) return longest.front();
  throw ConfigurationError(urdf.file(), 0, "--tip",
                           "is missing: several links are at the end of " + std::to_string(axes) + " axes",
                           config::alternatives(longest));
}

constexpr double kFarthest = 1e4;  // m, between two joints

/// Refuses frames that are too far for any arm, among them those with which rounding or overflow spoils a pose.
void check_distance(const Urdf& urdf, const Urdf::Joint& joint, const Pose& frame) {
  if (frame.translation().cwiseAbs().maxCoeff() <= kFarthest && is_rigid(frame)) return;
  throw ConfigurationError(urdf.file(), joint.line, "joint " + in_quotes(joint.name),
                           "is not at a place of an arm, from the joint before", "at most 10 km");
}

}  // namespace

UrdfArm arm_of(const Urdf& urdf, const std::string& base, const std::string& tip) {
  if (!base.empty()) check_link(urdf, "--base", base);
  const std::string from = base.empty() ? root_of(urdf) : base;
  if (!tip.empty()) check_link(urdf, "--tip", tip);
  const std::string to = tip.empty() ? end_of(urdf, from) : tip;
  const std::vector<const Urdf::Joint*> path = path_to(urdf, from, to);
  std::vector<Urdf::Joint> axes;
  std::vector<kinematics::ChainJoint> joints;
  Pose fixed = Pose::Identity();
  for (const Urdf::Joint* joint : path) {
    fixed = fixed * joint->origin;
    if (joint->type == Urdf::Type::fixed) continue;
    if (joint->mimic)
      throw ConfigurationError(urdf.file(), joint->line, "joint " + in_quotes(joint->name),
                               "follows joint " + in_quotes(joint->mimic->joint) + " and is between base and tip",
                               "a tip before it");
    check_distance(urdf, *joint, fixed);
    axes.push_back(*joint);
    joints.push_back({fixed, joint->axis, joint->type == Urdf::Type::prismatic});
    fixed = Pose::Identity();
  }
  if (!path.empty()) check_distance(urdf, *path.back(), fixed);
  if (axes.empty() || axes.size() > static_cast<std::size_t>(kMaxJoints))
    throw ConfigurationError(urdf.file(), urdf.line_of_link(to), "link " + in_quotes(to),
                             std::to_string(axes.size()) + " moving joints between it and link " + in_quotes(from),
                             "1 to " + std::to_string(kMaxJoints));
  return {from, to, axes, joints, fixed, kinematics::SerialChain(joints, fixed)};
}

}  // namespace mrroc::cli
