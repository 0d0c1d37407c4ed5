#include "cli/ros2/robot_frames.hpp"

#include <tinyxml2.h>

#include <filesystem>
#include <utility>

#include "cli/record/standard_messages.hpp"
#include "config/table.hpp"
#include "config/text/file_text.hpp"

namespace mrroc::cli {

namespace {

using messages::geometry_msgs::TransformStamped;
using Joint = edp::Urdf::Joint;

/// Pose of the joint's child in its parent.
Pose moved(const Joint& joint, double position) {
  Pose motion = Pose::Identity();
  if (joint.type == edp::Urdf::Type::prismatic)
    motion.translation() = position * joint.axis;
  else
    motion.linear() = Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
  return joint.origin * motion;
}

void make_absolute(tinyxml2::XMLElement& element, const std::filesystem::path& folder) {
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    make_absolute(*child, folder);
    const char* const name = std::string_view(child->Name()) == "mesh" ? child->Attribute("filename") : nullptr;
    if (name == nullptr || std::string_view(name).find("://") != std::string_view::npos) continue;
    child->SetAttribute("filename", ("file://" + (folder / name).lexically_normal().string()).c_str());
  }
}

std::string description_of(const std::filesystem::path& urdf) {
  tinyxml2::XMLDocument document;
  std::string text = config::read_file(urdf);
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS || document.RootElement() == nullptr)
    return text;
  make_absolute(*document.RootElement(), urdf.parent_path());
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

std::string root_of(const edp::Urdf& urdf) {
  for (const std::string& link : urdf.links())
    if (urdf.joint_above(link) == nullptr) return link;
  return {};
}

/// Arms from a URDF name the link that is their base frame; of others it is the root.
std::string base_link(const std::filesystem::path& parameters, const std::string& root) {
  const auto chain = config::Table::load(parameters).optional_table("chain");
  return chain ? chain->optional_text("base").value_or(root) : root;
}

}  // namespace

TransformStamped transform_of(std::string parent, std::string child, const Pose& pose) {
  TransformStamped transform;
  transform.header.frame_id = std::move(parent);
  transform.child_frame_id = std::move(child);
  const Eigen::Vector3d& position = pose.translation();
  const Eigen::Quaterniond rotation(pose.linear());
  transform.transform.translation = {position.x(), position.y(), position.z()};
  transform.transform.rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  return transform;
}

RobotFrames::RobotFrames(const config::RobotEntry& robot, std::string prefix, const std::string& world)
    : name_(robot.name), prefix_(std::move(prefix)), joints_(record::joint_names(robot)) {
  const config::RobotFiles files = robot.files();
  Pose root_in_base = Pose::Identity();
  std::string root = base_;
  if (std::filesystem::exists(files.urdf)) {
    urdf_ = edp::Urdf::load(files.urdf, edp::Urdf::Limits::optional);
    description_ = description_of(files.urdf);
    root = base_ = root_of(*urdf_);
    base_ = base_link(files.parameters, base_);
    root_in_base = urdf_->pose(base_, {}).inverse();
    for (const Joint& joint : urdf_->joints())
      if (joint.type == edp::Urdf::Type::fixed) add(joint, joint.origin, fixed_);
  }
  fixed_.push_back(transform_of(world, prefix_ + root, robot.known_base() * root_in_base));
}

std::string RobotFrames::tool() const { return prefix_ + record::tool_frame(name_); }

void RobotFrames::add(const Joint& joint, const Pose& pose, Transforms& transforms) const {
  transforms.push_back(transform_of(prefix_ + joint.parent, prefix_ + joint.child, pose));
}

void RobotFrames::append(const messages::builtin_interfaces::Time& stamp, std::span<const double> joints,
                         const Pose& tool_pose, const Pose& tool_in_flange, Transforms& transforms) const {
  const std::size_t first = transforms.size();
  std::map<std::string_view, double> positions;
  for (std::size_t i = 0; i < joints.size() && i < joints_.size(); ++i) positions[joints_[i]] = joints[i];
  if (urdf_) {
    for (const Joint& joint : urdf_->joints()) {
      if (joint.type == edp::Urdf::Type::fixed) continue;
      const auto leader = positions.find(joint.mimic ? joint.mimic->joint : joint.name);
      if (leader == positions.end()) continue;
      const double position =
          joint.mimic ? joint.mimic->multiplier * leader->second + joint.mimic->offset : leader->second;
      add(joint, moved(joint, position), transforms);
    }
  }
  transforms.push_back(transform_of(base(), flange(), tool_pose * tool_in_flange.inverse()));
  transforms.push_back(transform_of(base(), tool(), tool_pose));
  for (std::size_t i = first; i < transforms.size(); ++i) transforms[i].header.stamp = stamp;
}

}  // namespace mrroc::cli
