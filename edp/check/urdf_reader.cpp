#include "edp/check/urdf_reader.hpp"

#include <algorithm>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "config/text/xml_file.hpp"
#include "core/number_text.hpp"
#include "core/text_lines.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

using config::ConfigurationError;
using config::in_quotes;

namespace {

constexpr const char* kExpanded = "the URDF that the command xacro makes of this file";

}  // namespace

const UrdfReader::Element& UrdfReader::robot() {
  config::read_xml(file_, "a URDF", document_);
  const Element* robot = document_.RootElement();
  if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
    throw ConfigurationError(file_, robot == nullptr ? 1 : robot->GetLineNum(), "", "is not a URDF", "<robot>");
  }
  refuse_macros(*robot);
  return *robot;
}

std::string UrdfReader::text(const Element& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (value == nullptr || *value == '\0') fail(element, name, "missing", "a name");
  return value;
}

const UrdfReader::Element* UrdfReader::optional_child(const Element& element, const char* name) const {
  const Element* const found = element.FirstChildElement(name);
  const Element* const second = found != nullptr ? found->NextSiblingElement(name) : nullptr;
  if (second != nullptr) fail(*second, "", "a second one", "one");
  return found;
}

const UrdfReader::Element& UrdfReader::child(const Element& element, const char* name) const {
  const Element* found = optional_child(element, name);
  if (found == nullptr) fail(element, "", std::string("no <") + name + ">", "one");
  return *found;
}

std::vector<double> UrdfReader::all_numbers(const Element& element, const char* name, std::size_t size) const {
  const char* value = element.Attribute(name);
  if (value == nullptr) return {};
  std::string blanks = value;
  std::replace_if(
      blanks.begin(), blanks.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const std::vector<std::string_view> words = core::words_of(blanks);
  const std::string expected = size == 1 ? "a number" : std::to_string(size) + " numbers with blanks between";
  if (blanks.find("${") != std::string::npos || blanks.find("$(") != std::string::npos)
    fail(element, name, in_quotes(value) + " is a xacro expression", kExpanded);
  std::vector<double> result;
  for (const std::string_view word : words) {
    const auto number = core::to_finite(word);
    if (!number) {
      const char* const why = core::to_double(word) ? "is not finite" : nullptr;
      fail(element, name, in_quotes(word) + " " + (why != nullptr ? why : core::number_problem(word)), expected);
    }
    result.push_back(*number);
  }
  if (words.size() != size) fail(element, name, in_quotes(value), expected);
  return result;
}

std::optional<double> UrdfReader::number(const Element& element, const char* name) const {
  const std::vector<double> values = all_numbers(element, name, 1);
  return values.empty() ? std::nullopt : std::optional(values.front());
}

double UrdfReader::required(const Element& element, const char* name) const {
  const auto value = number(element, name);
  if (!value) fail(element, name, "missing", "a number");
  return *value;
}

void UrdfReader::only(const Element& element, const std::vector<std::string>& names) const {
  for (auto* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
    const std::string name = each->Name();
    const bool foreign = name.find(':') != std::string::npos;  // of another namespace
    if (!foreign && std::find(names.begin(), names.end(), name) == names.end())
      fail(element, name, "is unknown", config::alternatives(names));
  }
}

Pose UrdfReader::origin(const Element& element) const {
  const Element* const origin = optional_child(element, "origin");
  if (origin == nullptr) return Pose::Identity();
  only(*origin, {"xyz", "rpy"});  // a misspelt one would put the link elsewhere
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return pose_from_rpy(numbers<3>(*origin, "xyz", zero), numbers<3>(*origin, "rpy", zero));
}

void UrdfReader::fail(const Element& element, const std::string& attribute, const std::string& problem,
                      const std::string& expected) const {
  const std::string tag = std::string("<") + element.Name() + ">";
  throw ConfigurationError(file_, element.GetLineNum(), attribute.empty() ? tag : tag + " " + attribute, problem,
                           expected);
}

/// Rejects a xacro file that has not been expanded: it is XML, but not yet a URDF.
void UrdfReader::refuse_macros(const Element& robot) const {
  for (auto* each = robot.FirstChildElement(); each != nullptr; each = each->NextSiblingElement()) {
    if (std::string_view(each->Name()).starts_with("xacro:")) fail(*each, "", "is an element of xacro", kExpanded);
  }
}

}  // namespace mrroc::edp
