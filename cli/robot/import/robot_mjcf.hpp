#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/robot/import/axis_limits.hpp"
#include "cli/robot/import/findings.hpp"
#include "cli/robot/import/inertia.hpp"
#include "cli/robot/import/link_shapes.hpp"
#include "cli/robot/import/urdf_bodies.hpp"
#include "sim/scene/xml.hpp"

namespace mrroc::cli {

/// What an arm's MJCF contains that a model of it, once compiled, has shown.
struct MjcfExtras {
  std::map<std::string, double> armature;                  ///< of axes by name, kg m2 or kg
  std::set<std::pair<std::string, std::string>> excluded;  ///< pairs of bodies that do not collide
};

/// The MJCF of a URDF from the arm's base on: a body for each link, a hinge or slide for each joint, a motor for each
/// axis, sites `tool` and `wrist` at the tip, mimic joints as equality constraints, other joints held by springs.
/// Configuration time only.
class RobotMjcf {
 public:
  /// Checks inertias and mimic joints; what is guessed or ignored is added to `findings`. The arguments must outlive
  /// this object. Throws config::ConfigurationError as `LinkShapes::add`; a mimic joint whose leader does not exist.
  RobotMjcf(const edp::Urdf& urdf, const UrdfBodies& bodies, const UrdfArm& arm, const std::vector<AxisLimits>& axes,
            LinkShapes& shapes, Findings& findings);

  /// The whole file. Allocates only.
  sim::Element mjcf(const std::string& type, const MjcfExtras& extras) const;

 private:
  void take_link(const std::string& link, bool moves);
  void take_inertia(const UrdfBody& body, bool moves);
  void take_joint(const edp::Urdf::Joint& joint);
  sim::Element body_of(const std::string& link, const MjcfExtras& extras) const;
  sim::Element joint_of(const edp::Urdf::Joint& joint, const MjcfExtras& extras) const;
  sim::Element wrist() const;
  sim::Element mimics() const;
  bool is_axis(const std::string& joint) const;

  const edp::Urdf& urdf_;
  const UrdfBodies& bodies_;
  const UrdfArm& arm_;
  const std::vector<AxisLimits>& axes_;
  LinkShapes& shapes_;
  Findings& findings_;
  std::map<std::string, std::vector<const edp::Urdf::Joint*>> below_;  // joints by their parent link
  std::map<std::string, std::string> body_names_, joint_names_;        // by those of the URDF
  std::string tool_body_;                                              // empty: the tip's body is the tool
  std::map<std::string, BodyInertia> inertias_;                        // of links that have one
  std::vector<const edp::Urdf::Joint*> moving_;                        // from the base on
};

}  // namespace mrroc::cli
