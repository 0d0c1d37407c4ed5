#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/deployment.hpp"
#include "config/table.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::config {

/// The commands to one robot: jog, step, go, hold, synchronise, recover, bias, output.
bool is_robot_order(std::string_view command) noexcept;
/// The frames of jog and step: axes, base, tool, motors.
std::vector<std::string> order_frames();

/// The parameters of a robot of the deployment. Throws ConfigurationError.
RobotParameters parameters_of(const RobotEntry& robot);

/// The robot command of an order, for edp::OperatorMotion. Throws std::invalid_argument with the argument's name, its
/// value and what was expected: an unknown axis, frame, posture, tool or output, a value that is not finite or beyond
/// the axis's limit.
RobotCommand command_of(const std::string& command, const RobotOrder& order, const RobotParameters& parameters);

/// Reads the keys of an event with such a command: `robot`, and `axis`, `in`, `velocity`, `distance`, `posture`,
/// `output`, `value` as the command needs them. Throws ConfigurationError, also for what `command_of` refuses.
RobotOrder read_robot_order(const Table& table, const std::string& command, const Deployment& deployment);

}  // namespace mrroc::config
