#include "edp/check/urdf.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "edp/check/urdf_reader.hpp"

namespace mrroc::edp {

using config::ConfigurationError;
using config::in_quotes;
using tinyxml2::XMLElement;

namespace {

constexpr double kShortestAxis = 1e-9;

Urdf::Type type_of(const UrdfReader& reader, const XMLElement& element) {
  const std::string type = reader.text(element, "type");
  if (type == "fixed") return Urdf::Type::fixed;
  if (type == "revolute") return Urdf::Type::revolute;
  if (type == "continuous") return Urdf::Type::continuous;
  if (type == "prismatic") return Urdf::Type::prismatic;
  reader.fail(element, "type", in_quotes(type), config::alternatives({"fixed", "revolute", "continuous", "prismatic"}));
}

Eigen::Vector3d read_axis(const UrdfReader& reader, const XMLElement& element) {
  reader.only(element, {"xyz"});
  const Eigen::Vector3d axis = reader.numbers<3>(element, "xyz", Eigen::Vector3d::UnitX());
  const double length = axis.norm();
  if (!(length > kShortestAxis) || !std::isfinite(length)) reader.fail(element, "xyz", "no direction", "a vector");
  return axis.normalized();
}

/// The range of a continuous joint has no meaning. A <limit> without lower and upper is an incomplete one, no range of
/// 0.
void read_limit(const UrdfReader& reader, const XMLElement& element, Urdf::Limits limits, Urdf::Joint& joint) {
  const bool required = limits == Urdf::Limits::required;
  joint.limit_line = element.GetLineNum();
  for (const auto& [name, value] : {std::pair{"lower", &joint.lower}, {"upper", &joint.upper}}) {
    if (joint.type == Urdf::Type::continuous) continue;
    *value = reader.number(element, name);
  }
  if (joint.type != Urdf::Type::continuous && (required || joint.lower || joint.upper)) {
    joint.lower = joint.lower.value_or(0);
    joint.upper = joint.upper.value_or(0);
  }
  joint.effort = required ? reader.required(element, "effort") : reader.number(element, "effort");
  joint.velocity = required ? reader.required(element, "velocity") : reader.number(element, "velocity");
  joint.acceleration = reader.number(element, "drake:acceleration");  // the specification has none
}

/// The elements that only a moving joint has. Defaults and what is required: http://wiki.ros.org/urdf/XML/joint.
void read_motion(const UrdfReader& reader, const XMLElement& element, Urdf::Limits limits, Urdf::Joint& joint) {
  if (const XMLElement* axis = reader.optional_child(element, "axis")) joint.axis = read_axis(reader, *axis);
  const XMLElement* limit = reader.optional_child(element, "limit");
  if (limit == nullptr && joint.type != Urdf::Type::continuous && limits == Urdf::Limits::required)
    reader.fail(element, "name=" + in_quotes(joint.name), "no <limit>", "one with effort and velocity");
  if (limit != nullptr) read_limit(reader, *limit, limits, joint);
  if (const XMLElement* dynamics = reader.optional_child(element, "dynamics"))
    for (const char* name : {"damping", "friction"}) reader.number(*dynamics, name);
  if (const XMLElement* mimic = reader.optional_child(element, "mimic")) {
    joint.mimic = Urdf::Mimic{.joint = reader.text(*mimic, "joint"),
                              .multiplier = reader.number(*mimic, "multiplier").value_or(1),
                              .offset = reader.number(*mimic, "offset").value_or(0)};
  }
}

Urdf::Joint read_joint(const UrdfReader& reader, const XMLElement& element, Urdf::Limits limits) {
  Urdf::Joint joint;
  joint.line = element.GetLineNum();
  joint.name = reader.text(element, "name");
  joint.type = type_of(reader, element);
  joint.parent = reader.text(reader.child(element, "parent"), "link");
  joint.child = reader.text(reader.child(element, "child"), "link");
  joint.origin = reader.origin(element);
  if (joint.type != Urdf::Type::fixed) read_motion(reader, element, limits, joint);
  return joint;
}

}  // namespace

Urdf Urdf::load(const std::filesystem::path& file, Limits limits) {
  UrdfReader reader(file);
  const XMLElement& robot = reader.robot();
  Urdf urdf;
  urdf.file_ = file;
  for (auto* link = robot.FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link")) {
    const std::string name = reader.text(*link, "name");
    if (!urdf.links_.emplace(name, link->GetLineNum()).second) {
      reader.fail(*link, "name", in_quotes(name) + " is the name of an earlier link", "a unique name");
    }
  }
  if (urdf.links_.empty()) reader.fail(robot, "", "no <link>", "links");
  for (auto* element = robot.FirstChildElement("joint"); element != nullptr;
       element = element->NextSiblingElement("joint")) {
    Joint joint = read_joint(reader, *element, limits);
    for (const std::string& link : {joint.parent, joint.child}) {
      if (!urdf.has_link(link)) {
        reader.fail(*element, "name=" + in_quotes(joint.name), "no link " + in_quotes(link), "links of this file");
      }
    }
    if (urdf.joint(joint.name) != nullptr) {
      reader.fail(*element, "name", in_quotes(joint.name) + " is the name of an earlier joint", "a unique name");
    }
    if (urdf.joint_above(joint.child) != nullptr) {
      reader.fail(*element, "name=" + in_quotes(joint.name), "link " + in_quotes(joint.child) + " has two parents",
                  "a tree");
    }
    urdf.joints_.push_back(std::move(joint));
  }
  // every link has one parent at most: with one joint less than links and a path to the root from each, it is a tree
  for (const auto& [name, line] : urdf.links_) {
    std::size_t steps = 0;
    for (const Joint* up = urdf.joint_above(name); up != nullptr; up = urdf.joint_above(up->parent)) {
      if (++steps > urdf.joints_.size()) throw ConfigurationError(file, line, name, "is part of a ring", "a tree");
    }
  }
  if (urdf.joints_.size() + 1 != urdf.links_.size()) {
    reader.fail(robot, "",
                std::to_string(urdf.links_.size()) + " links, " + std::to_string(urdf.joints_.size()) + " joints",
                "one joint less than links: a tree");
  }
  return urdf;
}

std::vector<std::string> Urdf::links() const {
  std::vector<std::string> names;
  for (const auto& [name, line] : links_) names.push_back(name);
  return names;
}

const Urdf::Joint* Urdf::joint(const std::string& name) const {
  const auto found = std::find_if(joints_.begin(), joints_.end(), [&](const Joint& j) { return j.name == name; });
  return found == joints_.end() ? nullptr : &*found;
}

const Urdf::Joint* Urdf::joint_above(const std::string& link) const {
  const auto found = std::find_if(joints_.begin(), joints_.end(), [&](const Joint& j) { return j.child == link; });
  return found == joints_.end() ? nullptr : &*found;
}

Pose Urdf::pose(const std::string& link, const Positions& positions) const {
  Pose pose = Pose::Identity();
  for (const Joint* up = joint_above(link); up != nullptr; up = joint_above(up->parent)) {
    Pose moved = up->origin;
    if (up->type == Type::prismatic) moved.translate(up->axis * position(*up, positions));
    if (up->type == Type::revolute || up->type == Type::continuous) {
      moved.rotate(Eigen::AngleAxisd(position(*up, positions), up->axis));
    }
    pose = moved * pose;
  }
  return pose;
}

double Urdf::position(const Joint& joint, const Positions& positions) const {
  const auto own = positions.find(joint.name);
  if (own != positions.end()) return own->second;
  if (joint.mimic) {
    const auto followed = positions.find(joint.mimic->joint);
    if (followed != positions.end()) return joint.mimic->multiplier * followed->second + joint.mimic->offset;
  }
  throw ConfigurationError(file_, joint.line, "joint " + in_quotes(joint.name), "its position is not determined",
                           "an axis of the robot, a joint that follows one, or a fixed one");
}

}  // namespace mrroc::edp
