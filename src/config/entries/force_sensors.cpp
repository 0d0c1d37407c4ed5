#include "config/entries/force_sensors.hpp"

#include <algorithm>

#include "config/text/message_text.hpp"

namespace mrroc::config {

void check_force_sensors(const Table& root, const Deployment& deployment) {
  for (const RobotEntry& robot : deployment.robots) {
    if (robot.force_sensor.empty()) continue;
    const Table table = root.table("robots").table(robot.name);
    std::vector<std::string> suitable;
    for (const SensorEntry& sensor : deployment.sensors)
      if (sensor.type == "force_torque" && sensor.robot == robot.name) suitable.push_back(sensor.name);
    if (std::find(suitable.begin(), suitable.end(), robot.force_sensor) != suitable.end()) continue;
    table.fail("force_sensor", in_quotes(robot.force_sensor) + " is not a force sensor of " + in_quotes(robot.name),
               suitable.empty() ? "a sensor of type 'force_torque' with robot = " + in_quotes(robot.name)
                                : alternatives(suitable));
  }
}

}  // namespace mrroc::config
