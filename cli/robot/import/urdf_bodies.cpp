#include "cli/robot/import/urdf_bodies.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "config/text/message_text.hpp"
#include "edp/check/urdf_reader.hpp"

namespace mrroc::cli {

namespace {

using config::in_quotes;
using edp::UrdfReader;
using UrdfElement = UrdfReader::Element;
using Colours = std::map<std::string, Eigen::Vector4d>;

/// The elements of a robot's file with their materials.
class BodyReader {
 public:
  explicit BodyReader(const std::filesystem::path& file) : reader_(file), robot_(reader_.robot()) {
    for (auto* each = robot_.FirstChildElement("material"); each != nullptr;
         each = each->NextSiblingElement("material"))
      if (const auto colour = colour_of(*each)) colours_.insert_or_assign(name_of(*each), *colour);
  }

  const UrdfElement& robot() const noexcept { return robot_; }

  UrdfBody body(const UrdfElement& link) const {
    UrdfBody body;
    body.name = reader_.text(link, "name");
    body.line = link.GetLineNum();
    if (const UrdfElement* inertial = reader_.optional_child(link, "inertial")) body.inertial = inertial_of(*inertial);
    for (const auto& [tag, shapes] : {std::pair{"visual", &body.visuals}, {"collision", &body.collisions}})
      for (auto* each = link.FirstChildElement(tag); each != nullptr; each = each->NextSiblingElement(tag))
        shapes->push_back(shape_of(*each));
    return body;
  }

 private:
  static std::string name_of(const UrdfElement& element) {
    const char* const name = element.Attribute("name");
    return name != nullptr ? name : "";
  }

  std::optional<Eigen::Vector4d> colour_of(const UrdfElement& material) const {
    const UrdfElement* const colour = material.FirstChildElement("color");
    if (colour == nullptr) return {};
    return reader_.numbers<4>(*colour, "rgba", Eigen::Vector4d::Ones()).cwiseMax(0).cwiseMin(1);
  }

  UrdfInertial inertial_of(const UrdfElement& element) const {
    UrdfInertial inertial;
    inertial.line = element.GetLineNum();
    inertial.origin = reader_.origin(element);
    if (const UrdfElement* mass = reader_.optional_child(element, "mass"))
      inertial.mass = reader_.required(*mass, "value");
    const UrdfElement* const inertia = reader_.optional_child(element, "inertia");
    if (inertia == nullptr) return inertial;
    const auto entry = [&](const char* name) { return reader_.number(*inertia, name).value_or(0); };
    const double xy = entry("ixy"), xz = entry("ixz"), yz = entry("iyz");
    inertial.inertia << entry("ixx"), xy, xz, xy, entry("iyy"), yz, xz, yz, entry("izz");
    return inertial;
  }

  double positive(const UrdfElement& element, const char* name) const {
    const double value = reader_.required(element, name);
    if (!(value > 0)) reader_.fail(element, name, config::number_text(value) + " is not positive", "a number above 0");
    return value;
  }

  UrdfShape shape_of(const UrdfElement& element) const {
    UrdfShape shape;
    shape.line = element.GetLineNum();
    shape.origin = reader_.origin(element);
    if (const UrdfElement* material = element.FirstChildElement("material")) {
      const auto known = colours_.find(name_of(*material));
      shape.colour = colour_of(*material);
      if (!shape.colour && known != colours_.end()) shape.colour = known->second;
    }
    const UrdfElement& geometry = reader_.child(element, "geometry");
    const UrdfElement* const form = geometry.FirstChildElement();
    if (form == nullptr) reader_.fail(geometry, "", "is empty", "a shape");
    const std::string kind = form->Name();
    if (kind == "box") {
      shape.size = box_size(*form);
    } else if (kind == "cylinder" || kind == "capsule") {
      shape.kind = kind == "cylinder" ? UrdfShape::Kind::cylinder : UrdfShape::Kind::capsule;
      shape.size = {positive(*form, "radius"), positive(*form, "length"), 0};
    } else if (kind == "sphere") {
      shape.kind = UrdfShape::Kind::sphere;
      shape.size = {positive(*form, "radius"), 0, 0};
    } else if (kind == "mesh") {
      shape.kind = UrdfShape::Kind::mesh;
      shape.mesh = reader_.text(*form, "filename");
      shape.scale = reader_.numbers<3>(*form, "scale", Eigen::Vector3d::Ones());
      if ((shape.scale.array() == 0).any()) reader_.fail(*form, "scale", "is zero", "numbers that are not 0");
    } else {
      reader_.fail(*form, "", "is not a shape", config::alternatives({"box", "cylinder", "capsule", "sphere", "mesh"}));
    }
    return shape;
  }

  Eigen::Vector3d box_size(const UrdfElement& box) const {
    Eigen::Vector3d size = reader_.numbers<3>(box, "size", Eigen::Vector3d::Zero());
    if (!(size.minCoeff() > 0)) reader_.fail(box, "size", "is not positive", "three numbers above 0");
    return size;
  }

  UrdfReader reader_;
  const UrdfElement& robot_;
  Colours colours_;
};

/// The prefix of a name with a name space; empty without.
std::string name_space_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? "" : std::string(name.substr(0, colon));
}

/// Warns of every name space that no enclosing element declares.
void check_name_spaces(const UrdfElement& element, std::set<std::string> declared, std::set<std::string>& reported,
                       Findings& findings) {
  for (auto* each = element.FirstAttribute(); each != nullptr; each = each->Next())
    if (name_space_of(each->Name()) == "xmlns") declared.insert(std::string(each->Name()).substr(6));
  const auto check = [&](const char* name) {
    const std::string space = name_space_of(name);
    if (space.empty() || space == "xmlns" || space == "xml" || declared.contains(space)) return;
    if (std::string_view(name) == "drake:acceleration") return;  // axis_limits reads it
    if (reported.insert(space).second)
      findings.warn("the name space is not declared: its elements and attributes are ignored", in_quotes(name),
                    element.GetLineNum());
  };
  check(element.Name());
  for (auto* each = element.FirstAttribute(); each != nullptr; each = each->Next()) check(each->Name());
  for (auto* each = element.FirstChildElement(); each != nullptr; each = each->NextSiblingElement())
    check_name_spaces(*each, declared, reported, findings);
}

}  // namespace

const UrdfBody& UrdfBodies::body(const std::string& link) const {
  return *std::find_if(bodies.begin(), bodies.end(), [&](const UrdfBody& each) { return each.name == link; });
}

UrdfBodies read_urdf_bodies(const std::filesystem::path& file, Findings& findings) {
  const BodyReader reader(file);
  UrdfBodies result;
  const char* const name = reader.robot().Attribute("name");
  result.robot = name != nullptr ? name : "";
  std::set<std::string> reported;
  check_name_spaces(reader.robot(), {}, reported, findings);
  for (auto* link = reader.robot().FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link"))
    result.bodies.push_back(reader.body(*link));
  return result;
}

}  // namespace mrroc::cli
