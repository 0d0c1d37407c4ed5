#include "edp/check/urdf.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "config/text/xml_file.hpp"
#include "core/number_text.hpp"
#include "core/text_lines.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

using config::ConfigurationError;
using config::in_quotes;
using tinyxml2::XMLElement;

namespace {

constexpr double kShortestAxis = 1e-9;

/// The elements of one file; mistakes in them name it.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file) {}

  const XMLElement& robot() {
    config::read_xml(file_, "a URDF", document_);
    const XMLElement* robot = document_.RootElement();
    if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
      throw ConfigurationError(file_, robot == nullptr ? 1 : robot->GetLineNum(), "", "is not a URDF", "<robot>");
    }
    refuse_macros(*robot);
    return *robot;
  }

  std::string text(const XMLElement& element, const char* name) const {
    const char* value = element.Attribute(name);
    if (value == nullptr || *value == '\0') fail(element, name, "missing", "a name");
    return value;
  }

  const XMLElement& child(const XMLElement& element, const char* name) const {
    const XMLElement* found = element.FirstChildElement(name);
    if (found == nullptr) fail(element, "", std::string("no <") + name + ">", "one");
    return *found;
  }

  /// All numbers of an attribute, in any locale; `fallback` when it is missing.
  template <int size>
  Eigen::Matrix<double, size, 1> numbers(const XMLElement& element, const char* name,
                                         const Eigen::Matrix<double, size, 1>& fallback) const {
    const char* value = element.Attribute(name);
    if (value == nullptr) return fallback;
    std::string blanks = value;
    std::replace_if(
        blanks.begin(), blanks.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    const std::vector<std::string_view> words = core::words_of(blanks);
    const std::string expected = size == 1 ? "a number" : std::to_string(size) + " numbers with blanks between";
    if (blanks.find("${") != std::string::npos)
      fail(element, name, in_quotes(value) + " is a xacro expression", kExpanded);
    Eigen::Matrix<double, size, 1> result;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto number = core::to_finite(words[i]);
      if (!number) {
        const char* const why = core::to_double(words[i]) ? "is not finite" : nullptr;
        fail(element, name, in_quotes(words[i]) + " " + (why != nullptr ? why : core::number_problem(words[i])),
             expected);
      }
      if (i < size) result[static_cast<Eigen::Index>(i)] = *number;
    }
    if (words.size() != size) fail(element, name, in_quotes(value), expected);
    return result;
  }

  std::optional<double> number(const XMLElement& element, const char* name) const {
    if (element.Attribute(name) == nullptr) return std::nullopt;
    return numbers<1>(element, name, Eigen::Matrix<double, 1, 1>::Zero())[0];
  }

  double required(const XMLElement& element, const char* name) const {
    const auto value = number(element, name);
    if (!value) fail(element, name, "missing", "a number");
    return *value;
  }

  [[noreturn]] void fail(const XMLElement& element, const std::string& attribute, const std::string& problem,
                         const std::string& expected) const {
    const std::string tag = std::string("<") + element.Name() + ">";
    throw ConfigurationError(file_, element.GetLineNum(), attribute.empty() ? tag : tag + " " + attribute, problem,
                             expected);
  }

 private:
  static constexpr const char* kExpanded = "the URDF that the command xacro makes of this file";

  /// Rejects a xacro file that has not been expanded: it is XML, but not yet a URDF.
  void refuse_macros(const XMLElement& robot) const {
    for (auto* each = robot.FirstChildElement(); each != nullptr; each = each->NextSiblingElement()) {
      if (std::string_view(each->Name()).starts_with("xacro:")) fail(*each, "", "is an element of xacro", kExpanded);
    }
  }

  const std::filesystem::path& file_;
  tinyxml2::XMLDocument document_;
};

Urdf::Type type_of(const Reader& reader, const XMLElement& element) {
  const std::string type = reader.text(element, "type");
  if (type == "fixed") return Urdf::Type::fixed;
  if (type == "revolute") return Urdf::Type::revolute;
  if (type == "continuous") return Urdf::Type::continuous;
  if (type == "prismatic") return Urdf::Type::prismatic;
  reader.fail(element, "type", in_quotes(type), config::alternatives({"fixed", "revolute", "continuous", "prismatic"}));
}

Pose read_origin(const Reader& reader, const XMLElement& element) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return pose_from_rpy(reader.numbers<3>(element, "xyz", zero), reader.numbers<3>(element, "rpy", zero));
}

Eigen::Vector3d read_axis(const Reader& reader, const XMLElement& element) {
  const Eigen::Vector3d axis = reader.numbers<3>(element, "xyz", Eigen::Vector3d::UnitX());
  const double length = axis.norm();
  if (!(length > kShortestAxis) || !std::isfinite(length)) reader.fail(element, "xyz", "no direction", "a vector");
  return axis.normalized();
}

/// The range of a continuous joint has no meaning.
void read_limit(const Reader& reader, const XMLElement& element, Urdf::Joint& joint) {
  if (joint.type != Urdf::Type::continuous) {
    joint.lower = reader.number(element, "lower").value_or(0);
    joint.upper = reader.number(element, "upper").value_or(0);
  }
  reader.required(element, "effort");
  joint.velocity = reader.required(element, "velocity");
}

/// The elements that only a moving joint has. Defaults and what is required: http://wiki.ros.org/urdf/XML/joint.
void read_motion(const Reader& reader, const XMLElement& element, Urdf::Joint& joint) {
  if (const XMLElement* axis = element.FirstChildElement("axis")) joint.axis = read_axis(reader, *axis);
  const XMLElement* limit = element.FirstChildElement("limit");
  if (limit == nullptr && joint.type != Urdf::Type::continuous)
    reader.fail(element, "name=" + in_quotes(joint.name), "no <limit>", "one with effort and velocity");
  if (limit != nullptr) read_limit(reader, *limit, joint);
  if (const XMLElement* dynamics = element.FirstChildElement("dynamics"))
    for (const char* name : {"damping", "friction"}) reader.number(*dynamics, name);
  if (const XMLElement* mimic = element.FirstChildElement("mimic")) {
    joint.mimic = Urdf::Mimic{.joint = reader.text(*mimic, "joint"),
                              .multiplier = reader.number(*mimic, "multiplier").value_or(1),
                              .offset = reader.number(*mimic, "offset").value_or(0)};
  }
}

Urdf::Joint read_joint(const Reader& reader, const XMLElement& element) {
  Urdf::Joint joint;
  joint.line = element.GetLineNum();
  joint.name = reader.text(element, "name");
  joint.type = type_of(reader, element);
  joint.parent = reader.text(reader.child(element, "parent"), "link");
  joint.child = reader.text(reader.child(element, "child"), "link");
  if (const XMLElement* origin = element.FirstChildElement("origin")) joint.origin = read_origin(reader, *origin);
  if (joint.type != Urdf::Type::fixed) read_motion(reader, element, joint);
  return joint;
}

}  // namespace

Urdf Urdf::load(const std::filesystem::path& file) {
  Reader reader(file);
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
    Joint joint = read_joint(reader, *element);
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
