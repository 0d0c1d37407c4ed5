#include "sim/scene/placement.hpp"

#include <array>
#include <initializer_list>
#include <iomanip>
#include <locale>
#include <sstream>
#include <utility>

#include "config/table.hpp"

namespace mrroc::sim {

namespace {

constexpr std::array<std::string_view, 6> kFrame{"pos", "quat", "axisangle", "euler", "xyaxes", "zaxis"};

std::string numbers(std::initializer_list<double> values) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(17);
  for (const double value : values) out << (out.tellp() > 0 ? " " : "") << value;
  return out.str();
}

Element based(const RobotPart& robot, const MjcfPart& part) {
  Element body{"body", {{"name", robot.name}}, part.world, part.origin};
  set_pose(body, robot.base);
  body.set("childclass", part.main_class);
  return body;
}

/// The element `site` of this name and the body that it is in.
struct Site {
  Element* body = nullptr;
  Element site;
};

Site find_site(Element& body, const std::string& name) {
  for (const Element& child : body.children) {
    if (child.name == "site" && child.value_or("name", "") == name) return {&body, child};
  }
  for (Element& child : body.children) {
    if (child.name != "body") continue;
    if (Site found = find_site(child, name); found.body != nullptr) return found;
  }
  return {};
}

/// A body at the site that holds `body`.
Element at_site(const Element& site, Element body) {
  Element frame{"body", {}, {}, site.origin};
  for (const std::string_view key : kFrame) {
    if (const std::string* value = site.find(key)) frame.set(key, *value);
  }
  frame.children.push_back(std::move(body));
  return frame;
}

/// Robot `index` with all robots that it carries.
Element placed(std::size_t index, const std::vector<RobotPart>& robots, const std::vector<MjcfPart>& parts) {
  Element body = based(robots[index], parts[index]);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].mount != robots[index].name) continue;
    const Site tool = find_site(body, robots[index].name + "/tool");
    if (tool.body == nullptr) {
      const Origin& at = parts[index].origin;
      throw config::ConfigurationError(*at.file, at.line, "robots." + robots[i].name + ".mount",
                                       "there is no site \"tool\" to carry it", "<site name=\"tool\"/> in this file");
    }
    tool.body->children.push_back(at_site(tool.site, placed(i, robots, parts)));
  }
  return body;
}

}  // namespace

void set_pose(Element& body, const Pose& pose) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  body.set("pos", numbers({p.x(), p.y(), p.z()}));
  body.set("quat", numbers({q.w(), q.x(), q.y(), q.z()}));
}

Element take_frame(Element& body) {
  Element frame{"body", {}, {}, body.origin};
  for (const std::string_view key : kFrame) {
    if (const std::string* value = body.find(key)) frame.set(key, *value);
    body.remove(key);
  }
  return frame;
}

std::vector<Element> place_robots(const std::vector<RobotPart>& robots, const std::vector<MjcfPart>& parts) {
  std::vector<Element> bodies;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robots[i].mount.empty()) bodies.push_back(placed(i, robots, parts));
  }
  return bodies;
}

}  // namespace mrroc::sim
