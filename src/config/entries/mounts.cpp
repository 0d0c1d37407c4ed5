#include "config/entries/mounts.hpp"

#include <algorithm>

#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// nullptr: not mounted, or there is no robot of that name.
const RobotEntry* carrier(const RobotEntry& robot, const Deployment& deployment) {
  const auto named = [&robot](const RobotEntry& each) { return each.name == robot.mount; };
  const auto found = std::find_if(deployment.robots.begin(), deployment.robots.end(), named);
  return found == deployment.robots.end() ? nullptr : &*found;
}

bool carries_itself(const RobotEntry& robot, const Deployment& deployment) {
  const RobotEntry* each = carrier(robot, deployment);
  // a ring that carries `robot` but does not contain it is reported at its own robots
  for (std::size_t i = 0; each != nullptr && i < deployment.robots.size(); ++i) {
    if (each == &robot) return true;
    each = carrier(*each, deployment);
  }
  return false;
}

std::vector<std::string> names_of_others(const RobotEntry& robot, const Deployment& deployment) {
  std::vector<std::string> names;
  for (const auto& each : deployment.robots) {
    if (each.name != robot.name) names.push_back(each.name);
  }
  return names;
}

}  // namespace

void check_mounts(const Table& root, const Deployment& deployment) {
  for (const auto& robot : deployment.robots) {
    if (robot.mount.empty()) continue;
    const auto fail = [&](const std::string& problem, const std::string& expected) {
      root.table("robots").table(robot.name).fail("mount", problem, expected);
    };
    const RobotEntry* parent = carrier(robot, deployment);
    if (parent == nullptr) fail("no robot " + in_quotes(robot.mount), alternatives(names_of_others(robot, deployment)));
    if (carries_itself(robot, deployment)) {
      fail(in_quotes(robot.name) + " would carry itself", "no ring of robots that carry each other");
    }
    if (robot.in_world() && !parent->in_world()) {
      fail(in_quotes(robot.mount) + " is not in the simulated world", "a robot whose hardware is 'mujoco'");
    }
  }
}

}  // namespace mrroc::config
