#include "sim/scene/compose.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "config/table.hpp"
#include "sim/errors/misplaced_links.hpp"
#include "sim/scene/mjcf_part.hpp"
#include "sim/scene/names.hpp"
#include "sim/scene/placement.hpp"

namespace mrroc::sim {

using config::ConfigurationError;

namespace {

/// Compiler settings with MuJoCo's defaults; one value holds for the whole world.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kCompilerDefaults{{
    {"angle", "degree"},
    {"autolimits", "false"},
    {"balanceinertia", "false"},
    {"boundinertia", "0"},
    {"boundmass", "0"},
    {"convexhull", "true"},
    {"coordinate", "local"},
    {"discardvisual", "false"},
    {"eulerseq", "xyz"},
    {"exactmeshinertia", "false"},
    {"fitaabb", "false"},
    {"fusestatic", "false"},
    {"inertiafromgeom", "auto"},
    {"inertiagrouprange", "0 5"},
    {"settotalmass", "-1"},
}};

void check_same_compiler(const MjcfPart& scene, const MjcfPart& robot) {
  for (const auto& [key, fallback] : kCompilerDefaults) {
    const std::string in_scene = scene.compiler.value_or(key, fallback);
    const std::string in_robot = robot.compiler.value_or(key, fallback);
    if (in_scene == in_robot) continue;
    const Origin& at = scene.compiler.origin;
    throw ConfigurationError(*at.file, at.line, "compiler." + std::string(key),
                             std::string("\"").append(in_scene).append("\" differs from \"").append(in_robot) +
                                 "\" in " + robot.compiler.origin.file->string(),
                             "<compiler " + std::string(key) + "=\"" + in_robot + "\"/> in every file");
  }
}

Element element(std::string name, std::vector<std::pair<std::string, std::string>> attributes, const Origin& origin,
                std::vector<Element> children = {}) {
  return {std::move(name), std::move(attributes), std::move(children), origin};
}

/// Puts a direct child of the world under default class `name` unless it has one.
void give_class(Element& top, const std::string& name) {
  constexpr std::array<std::string_view, 4> kWithClass{"camera", "geom", "light", "site"};
  const bool is_body = top.name == "body";
  if (!is_body && std::find(kWithClass.begin(), kWithClass.end(), top.name) == kWithClass.end()) return;
  const std::string key = is_body ? "childclass" : "class";
  top.set(key, top.value_or(key, name));
}

/// Declares the wrist's sensor unless the robot's MJCF has done so.
void add_force_torque(const RobotPart& robot, const MjcfPart& part, std::vector<Element>& sections) {
  const std::string name = robot.name + "/force_torque/";
  for (const Element& section : part.sections) {
    for (const Element& sensor : section.children) {
      if (section.name == "sensor" && sensor.value_or("name", "").starts_with(name)) return;
    }
  }
  const std::string site = robot.name + "/wrist";
  sections.push_back(element("sensor", {}, part.origin,
                             {element("force", {{"name", name + "force"}, {"site", site}}, part.origin),
                              element("torque", {{"name", name + "torque"}, {"site", site}}, part.origin)}));
}

bool any_child(const std::vector<Element>& sections, std::string_view section, auto&& condition) {
  return std::any_of(sections.begin(), sections.end(), [&](const Element& each) {
    return each.name == section && std::any_of(each.children.begin(), each.children.end(), condition);
  });
}

/// Adds elements that a picture needs and the scene lacks.
void add_scenery(const MjcfPart& scene, std::vector<Element>& sections, std::vector<Element>& world) {
  const Origin& at = scene.origin;
  if (std::none_of(world.begin(), world.end(), [](const Element& each) { return each.name == "light"; })) {
    world.push_back(element("light",
                            {{"directional", "true"},
                             {"pos", "0 0 4"},
                             {"dir", "-0.4 0.5 -1"},
                             {"diffuse", "0.7 0.7 0.7"},
                             {"specular", "0.2 0.2 0.2"}},
                            at));
  }
  if (!any_child(sections, "asset", [](const Element& each) { return each.value_or("type", "") == "skybox"; })) {
    sections.push_back(element("asset", {}, at,
                               {element("texture",
                                        {{"type", "skybox"},
                                         {"builtin", "gradient"},
                                         {"rgb1", "0.93 0.95 0.97"},
                                         {"rgb2", "0.6 0.7 0.8"},
                                         {"width", "256"},
                                         {"height", "1536"}},
                                        at)}));
  }
  if (std::none_of(sections.begin(), sections.end(), [](const Element& each) { return each.name == "visual"; })) {
    sections.push_back(element(
        "visual", {}, at,
        {element("headlight", {{"ambient", "0.3 0.3 0.3"}, {"diffuse", "0.2 0.2 0.2"}, {"specular", "0 0 0"}}, at),
         element("quality", {{"shadowsize", "4096"}}, at)}));
  }
}

}  // namespace

Composition compose(const std::filesystem::path& scene_file, const std::vector<RobotPart>& robots) {
  const MjcfPart scene = read_part(scene_file, "");
  Element defaults = element("default", {}, scene.origin, {scene.defaults});
  std::vector<Element> sections = scene.sections;
  std::vector<Element> world = scene.world;
  for (Element& top : world) give_class(top, scene.main_class);
  std::vector<MjcfPart> parts;
  for (const RobotPart& robot : robots) {
    parts.push_back(read_part(robot.mjcf, robot.name + "/"));
    check_same_compiler(scene, parts.back());
    if (robot.errors) misplace_links(parts.back().world, *robot.errors, robot.name);
  }
  std::ranges::move(place_robots(robots, parts), std::back_inserter(world));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    MjcfPart& part = parts[i];
    defaults.children.push_back(std::move(part.defaults));
    std::erase_if(part.sections, [](const Element& section) {
      return section.name == "option" || section.name == "size" || section.name == "visual" ||
             section.name == "statistic";
    });
    if (robots[i].force_torque) add_force_torque(robots[i], part, sections);
    std::move(part.sections.begin(), part.sections.end(), std::back_inserter(sections));
  }
  add_scenery(scene, sections, world);

  Element root = element("mujoco", {{"model", scene_file.stem().string()}}, scene.origin);
  root.children.push_back(scene.compiler);
  root.children.push_back(std::move(defaults));
  std::move(sections.begin(), sections.end(), std::back_inserter(root.children));
  root.children.push_back(element("worldbody", {}, scene.origin, std::move(world)));
  std::vector<std::string> names;
  names.reserve(robots.size());
  for (const RobotPart& robot : robots) names.push_back(robot.name);
  check_names(root, names);
  Text text = write(root);
  return {scene_file, std::move(root), std::move(text)};
}

}  // namespace mrroc::sim
