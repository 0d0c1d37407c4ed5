#include "cli/record/standard_messages.hpp"

#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"

namespace mrroc::cli::record {

std::vector<std::string> joint_names(const config::RobotEntry& robot) {
  const auto parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
  std::vector<std::string> names;
  for (const AxisParameters& axis : parameters.axes) names.push_back(axis.name);
  return names;
}

std::string joint_topic(const std::string& robot) { return "/" + robot + "/joint_states"; }
std::string wrench_topic(const std::string& name) { return "/" + name + "/wrench"; }
std::string tool_frame(const std::string& robot) { return robot + "_tool"; }

messages::geometry_msgs::WrenchStamped to_wrench(const std::string& frame,
                                                 const messages::builtin_interfaces::Time& stamp,
                                                 std::span<const double, 6> values) {
  messages::geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  message.wrench.force = {values[0], values[1], values[2]};
  message.wrench.torque = {values[3], values[4], values[5]};
  return message;
}

}  // namespace mrroc::cli::record
