#include "config/entries/force_sensors.hpp"

#include <algorithm>

#include "config/entries/named_file.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

void settle_force_sensors(const Table& root, Deployment& deployment) {
  for (const RobotEntry& robot : deployment.robots) {
    if (robot.force_sensor.empty()) continue;
    const Table table = root.table("robots").table(robot.name);
    std::vector<std::string> suitable;
    for (SensorEntry& sensor : deployment.sensors) {
      if (!sensor.gives_wrench || sensor.robot != robot.name) continue;
      suitable.push_back(sensor.name);
      if (sensor.name == robot.force_sensor && robot.host == deployment.here)
        sensor.wrench_library = require_library(table, "force_sensor", "sensors", sensor.type);
    }
    if (std::find(suitable.begin(), suitable.end(), robot.force_sensor) != suitable.end()) continue;
    table.fail("force_sensor", in_quotes(robot.force_sensor) + " is not a force sensor of " + in_quotes(robot.name),
               suitable.empty() ? "a sensor of type 'force_torque' with robot = " + in_quotes(robot.name)
                                : alternatives(suitable));
  }
}

}  // namespace mrroc::config
