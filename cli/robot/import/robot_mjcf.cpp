#include "cli/robot/import/robot_mjcf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/robot/import/mjcf_elements.hpp"
#include "cli/robot/import/names.hpp"
#include "config/table.hpp"

namespace mrroc::cli {

namespace {

using config::in_quotes;
using config::number_text;
using edp::Urdf;
using sim::Element;

constexpr double kStopTurn = 0.05, kStopSlide = 0.005;   // rad, m: of the stops beyond the limits
constexpr double kHoldArmature = 0.01, kHoldMass = 0.5;  // kg m2, kg: of joints that springs hold
constexpr double kHoldFrequency = 5;                     // Hz

bool moves_along(const Urdf::Joint& joint) { return joint.type == Urdf::Type::prismatic; }

/// The position in the joint's range that is nearest to 0.
double rest_of(const Urdf::Joint& joint) {
  if (!joint.lower || !joint.upper || *joint.lower > *joint.upper) return 0;
  return std::clamp(0.0, *joint.lower, *joint.upper);
}

void add_range(Attributes& attributes, double lower, double upper, double margin) {
  if (!std::isfinite(lower) || !std::isfinite(upper) || lower > upper) return;
  attributes.emplace_back("limited", "true");
  attributes.emplace_back("range", number_text(lower - margin) + " " + number_text(upper + margin));
}

Element inertial_of(const BodyInertia& inertia) {
  const Eigen::Quaterniond q(inertia.axes.linear());
  return mjcf_element("inertial", {{"pos", mjcf_numbers(Eigen::Vector3d(inertia.axes.translation()))},
                                   {"quat", mjcf_numbers(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()))},
                                   {"mass", number_text(inertia.mass)},
                                   {"diaginertia", mjcf_numbers(inertia.moments)}});
}

Element defaults_of(const std::string& type) {
  return mjcf_element(
      "default", {},
      {mjcf_element("default", {{"class", type}},
                    {// masses are those of the bodies
                     mjcf_element("geom", {{"mass", "0"}, {"rgba", "0.75 0.76 0.78 1"}, {"group", "2"}}),
                     mjcf_element("site", {{"size", "0.005"}, {"rgba", "0.2 0.4 0.9 1"}, {"group", "4"}}),
                     mjcf_element("default", {{"class", "visual"}},
                                  {mjcf_element("geom", {{"contype", "0"}, {"conaffinity", "0"}, {"group", "2"}})}),
                     mjcf_element("default", {{"class", "collision"}}, {mjcf_element("geom", {{"group", "3"}})})})});
}

}  // namespace

RobotMjcf::RobotMjcf(const Urdf& urdf, const UrdfBodies& bodies, const UrdfArm& arm,
                     const std::vector<AxisLimits>& axes, LinkShapes& shapes, Findings& findings)
    : urdf_(urdf), bodies_(bodies), arm_(arm), axes_(axes), shapes_(shapes), findings_(findings) {
  std::vector<std::string> links, joints;
  for (const UrdfBody& body : bodies.bodies) links.push_back(body.name);
  for (const AxisLimits& axis : axes) joints.push_back(axis.name);  // first: they keep their names
  for (const Urdf::Joint& joint : urdf.joints()) {
    below_[joint.parent].push_back(&joint);
    joints.push_back(joint.name);
  }
  // the tip's body is the tool if it is fixed to the flange: what is beyond the joint's own link is measured
  const Urdf::Joint* const above = urdf.joint_above(arm.tip);
  const bool own = above != nullptr && above->type == Urdf::Type::fixed && arm.tip != arm.base;
  links.emplace_back("tool");
  const std::vector<std::string> body_names = unique_names(links, std::string::npos);
  if (!own) tool_body_ = body_names.back();
  for (std::size_t i = 0; i < bodies.bodies.size(); ++i) body_names_[links[i]] = body_names[i];
  const std::vector<std::string> joint_names = unique_names(joints, std::string::npos);
  for (std::size_t i = 0; i < urdf.joints().size(); ++i)
    joint_names_[urdf.joints()[i].name] = joint_names[axes.size() + i];
  for (std::size_t i = 0; i < axes.size(); ++i) joint_names_[arm.axes[i].name] = axes[i].name;
  take_link(arm.base, false);
}

bool RobotMjcf::is_axis(const std::string& joint) const {
  return std::any_of(arm_.axes.begin(), arm_.axes.end(), [&](const Urdf::Joint& axis) { return axis.name == joint; });
}

void RobotMjcf::take_link(const std::string& link, bool moves) {
  const UrdfBody& body = bodies_.body(link);
  shapes_.add(body);
  const Urdf::Joint* const above = link == arm_.base ? nullptr : urdf_.joint_above(link);
  const bool moves_itself = above != nullptr && above->type != Urdf::Type::fixed;
  if (moves && (moves_itself || body.inertial || !shapes_.box(link).isEmpty())) take_inertia(body, moves_itself);
  for (const Urdf::Joint* joint : below_[link]) {
    const bool fixed = joint->type == Urdf::Type::fixed;
    if (!fixed) take_joint(*joint);
    take_link(joint->child, moves || !fixed);
  }
}

void RobotMjcf::take_inertia(const UrdfBody& body, bool moves) {
  const Eigen::AlignedBox3d& box = shapes_.box(body.name);
  const std::string problem = body.inertial ? inertia_problem(*body.inertial, box) : "no <inertial>";
  if (problem.empty()) {
    inertias_[body.name] = principal_inertia(*body.inertial);
    return;
  }
  // a frame without extent, fixed to another link, has no mass
  if (!moves && box.isEmpty()) return;
  inertias_[body.name] = guessed_inertia(box);
  findings_.guess(problem + (box.isEmpty() ? ": a ball of 0.1 kg" : ": the box around its shape, with 500 kg/m3"),
                  "link " + in_quotes(body.name), body.inertial ? body.inertial->line : body.line);
}

void RobotMjcf::take_joint(const Urdf::Joint& joint) {
  moving_.push_back(&joint);
  if (is_axis(joint.name)) return;
  const std::string subject = "joint " + in_quotes(joint.name);
  if (!joint.mimic) {
    findings_.guess("is not between base and tip: a spring holds it", subject, joint.line);
    return;
  }
  const Urdf::Joint* const leader = urdf_.joint(joint.mimic->joint);
  if (leader == nullptr || leader->type == Urdf::Type::fixed)
    throw config::ConfigurationError(urdf_.file(), joint.line, subject + " <mimic>",
                                     in_quotes(joint.mimic->joint) + (leader == nullptr ? " is no joint" : " is fixed"),
                                     "a joint that moves");
  findings_.warn("follows joint " + in_quotes(joint.mimic->joint) + " by an equality constraint", subject, joint.line);
}

Element RobotMjcf::joint_of(const Urdf::Joint& joint, const MjcfExtras& extras) const {
  const bool slides = moves_along(joint);
  const std::string& name = joint_names_.at(joint.name);
  Attributes attributes{{"name", name}, {"type", slides ? "slide" : "hinge"}, {"axis", mjcf_numbers(joint.axis)}};
  const auto axis = std::find_if(axes_.begin(), axes_.end(), [&](const AxisLimits& each) { return each.name == name; });
  if (axis != axes_.end()) {
    add_range(attributes, axis->position_min.value, axis->position_max.value, slides ? kStopSlide : kStopTurn);
    const auto armature = extras.armature.find(name);
    if (armature != extras.armature.end()) attributes.emplace_back("armature", number_text(armature->second));
    return mjcf_element("joint", attributes);
  }
  if (joint.type != Urdf::Type::continuous && joint.lower && joint.upper && *joint.lower < *joint.upper)
    add_range(attributes, *joint.lower, *joint.upper, 0);
  const double inertia = slides ? kHoldMass : kHoldArmature, rate = 2 * std::numbers::pi * kHoldFrequency;
  attributes.emplace_back("armature", number_text(inertia));
  attributes.emplace_back("damping", number_text(2 * inertia * rate));
  if (!joint.mimic) {
    attributes.emplace_back("stiffness", number_text(inertia * rate * rate));
    attributes.emplace_back("springref", number_text(rest_of(joint)));
  }
  return mjcf_element("joint", attributes);
}

Element RobotMjcf::body_of(const std::string& link, const MjcfExtras& extras) const {
  Attributes attributes{{"name", body_names_.at(link)}};
  std::vector<Element> parts;
  const Urdf::Joint* const above = link == arm_.base ? nullptr : urdf_.joint_above(link);
  if (above != nullptr) add_mjcf_pose(attributes, above->origin);
  const auto inertia = inertias_.find(link);
  if (inertia != inertias_.end())
    parts.push_back(inertial_of(inertia->second));
  else if (!shapes_.geoms(link).empty())  // else MuJoCo computes it from the geoms
    parts.push_back(inertial_of({}));
  if (above != nullptr && above->type != Urdf::Type::fixed) parts.push_back(joint_of(*above, extras));
  const std::vector<Element>& geoms = shapes_.geoms(link);
  parts.insert(parts.end(), geoms.begin(), geoms.end());
  if (link == arm_.axes.back().child) parts.push_back(wrist());
  if (link == arm_.tip) {
    const Element tool = mjcf_element("site", {{"name", "tool"}});
    parts.push_back(tool_body_.empty() ? tool : mjcf_element("body", {{"name", tool_body_}}, {tool}));
  }
  const auto below = below_.find(link);
  if (below != below_.end())
    for (const Urdf::Joint* joint : below->second) parts.push_back(body_of(joint->child, extras));
  return mjcf_element("body", attributes, parts);
}

/// At the tip, in the body of the last axis: the sensor there feels all that this axis carries.
Element RobotMjcf::wrist() const {
  Pose tip = Pose::Identity();
  for (std::string link = arm_.tip; link != arm_.axes.back().child; link = urdf_.joint_above(link)->parent)
    tip = urdf_.joint_above(link)->origin * tip;
  Attributes attributes{{"name", "wrist"}};
  add_mjcf_pose(attributes, tip);
  return mjcf_element("site", attributes);
}

Element RobotMjcf::mimics() const {
  std::vector<Element> constraints;
  for (const Urdf::Joint* joint : moving_) {
    if (!joint->mimic || is_axis(joint->name)) continue;
    const bool here = std::any_of(moving_.begin(), moving_.end(),
                                  [&](const Urdf::Joint* each) { return each->name == joint->mimic->joint; });
    Attributes attributes{{"joint1", joint_names_.at(joint->name)}};
    if (here) attributes.emplace_back("joint2", joint_names_.at(joint->mimic->joint));
    attributes.emplace_back("polycoef",
                            number_text(joint->mimic->offset) + " " + number_text(joint->mimic->multiplier) + " 0 0 0");
    constraints.push_back(mjcf_element("joint", attributes));
  }
  return mjcf_element("equality", {}, constraints);
}

Element RobotMjcf::mjcf(const std::string& type, const MjcfExtras& extras) const {
  Element base = body_of(arm_.base, extras);
  base.set("childclass", type);
  std::vector<Element> excluded, motors;
  for (const auto& [one, other] : extras.excluded)
    excluded.push_back(mjcf_element("exclude", {{"body1", one}, {"body2", other}}));
  for (const AxisLimits& axis : axes_)
    motors.push_back(mjcf_element("motor", {{"name", axis.name}, {"joint", axis.name}}));
  Element root =
      mjcf_element("mujoco", {{"model", type}},
                   {mjcf_element("compiler", {{"angle", "radian"}, {"meshdir", "meshes"}}), defaults_of(type),
                    mjcf_element("asset", {}, shapes_.assets()), mjcf_element("worldbody", {}, {base}),
                    mjcf_element("contact", {}, excluded), mimics(), mjcf_element("actuator", {}, motors)});
  std::erase_if(root.children,
                [](const Element& section) { return section.children.empty() && section.name != "compiler"; });
  return root;
}

}  // namespace mrroc::cli
