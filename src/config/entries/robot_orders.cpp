#include "config/entries/robot_orders.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "config/robot_parameters_file.hpp"
#include "config/text/message_text.hpp"
#include "core/nearest_word.hpp"
#include "core/number_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::string_view kOrders[]{"jog", "step", "go", "hold", "synchronise", "recover", "bias", "output", "tool"};
constexpr std::string_view kDirections[]{"x", "y", "z", "rx", "ry", "rz"};
constexpr double kFastest = 1.0;  // m/s or rad/s of the tool
constexpr double kLongest = 1.0;  // m or rad of a step of the tool

[[noreturn]] void refuse(const std::string& argument, const std::string& problem, const std::string& expected) {
  throw std::invalid_argument(argument + ": " + problem + ", expected " + expected);
}

[[noreturn]] void refuse_word(const std::string& argument, const std::string& word,
                              const std::vector<std::string>& known) {
  const std::string nearest = core::nearest_word(word, known);
  if (!nearest.empty())
    throw std::invalid_argument(argument + ": " + in_quotes(word) + ", did you mean " + in_quotes(nearest) + "?");
  refuse(argument, in_quotes(word) + " is unknown", alternatives(known));
}

void check_amount(const std::string& argument, double amount, double limit) {
  if (std::abs(amount) <= limit) return;
  refuse(argument, number_text(amount) + " is out of range", expected_number({-limit, limit}));
}

/// Index of an axis of the tool; none: it is something else.
std::optional<std::size_t> direction_named(const std::string& axis) {
  const auto found = std::find(std::begin(kDirections), std::end(kDirections), axis);
  if (found == std::end(kDirections)) return std::nullopt;
  return static_cast<std::size_t>(found - std::begin(kDirections));
}

/// Index of an axis, by its name or its number from 1.
std::size_t axis_of(const RobotOrder& order, const RobotParameters& parameters) {
  std::vector<std::string> names;
  for (const AxisParameters& axis : parameters.axes) names.push_back(axis.name);
  const auto named = std::find(names.begin(), names.end(), order.axis);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  const auto number = core::to_finite(order.axis);
  if (number && *number >= 1 && *number <= static_cast<double>(names.size()) && *number == std::floor(*number))
    return static_cast<std::size_t>(*number) - 1;
  if (direction_named(order.axis))
    refuse("axis", in_quotes(order.axis) + " is an axis of the tool",
           "in = tool or base with it, or " + alternatives(names));
  refuse_word("axis", order.axis, names);
}

std::size_t direction_of(const RobotOrder& order) {
  if (const auto direction = direction_named(order.axis)) return *direction;
  refuse_word("axis", order.axis, {std::begin(kDirections), std::end(kDirections)});
}

JointVector one_axis(const RobotParameters& parameters, std::size_t axis, double value) {
  JointVector values = JointVector::Zero(static_cast<Eigen::Index>(parameters.axes.size()));
  values[static_cast<Eigen::Index>(axis)] = value;
  return values;
}

void fill_jog(const RobotOrder& order, const RobotParameters& parameters, RobotCommand& command) {
  if (order.frame == "base" || order.frame == "tool") {
    check_amount("velocity", order.amount, kFastest);
    command.kind = CommandKind::twist;
    command.relative = order.frame == "tool";
    command.twist[static_cast<Eigen::Index>(direction_of(order))] = order.amount;
    return;
  }
  const std::size_t axis = axis_of(order, parameters);
  const bool motors = order.frame == "motors";
  if (!motors) check_amount("velocity", order.amount, parameters.axes[axis].velocity_max);
  command.kind = motors ? CommandKind::motor : CommandKind::joint_velocity;
  command.joint_velocity = one_axis(parameters, axis, order.amount);
}

void fill_step(const RobotOrder& order, const RobotParameters& parameters, RobotCommand& command) {
  command.relative = true;
  if (order.frame == "base" || order.frame == "tool") {
    check_amount("distance", order.amount, kLongest);
    const std::size_t direction = direction_of(order);
    command.kind = CommandKind::pose;
    command.interpolation = Interpolation::task;
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    vector[static_cast<Eigen::Index>(direction % 3)] = 1;
    if (order.frame == "base")
      command.twist[static_cast<Eigen::Index>(direction)] = order.amount;
    else if (direction < 3)
      command.pose.translation() = order.amount * vector;
    else
      command.pose.linear() = Eigen::AngleAxisd(order.amount, vector).toRotationMatrix();
    return;
  }
  const std::size_t axis = axis_of(order, parameters);
  const bool motors = order.frame == "motors";
  command.kind = motors ? CommandKind::motor : CommandKind::joint;
  command.interpolation = motors ? Interpolation::motors : Interpolation::joints;
  command.joints = one_axis(parameters, axis, order.amount);
}

void fill_go(const RobotOrder& order, const RobotParameters& parameters, RobotCommand& command) {
  const auto posture = parameters.postures.find(order.posture);
  if (posture == parameters.postures.end()) {
    std::vector<std::string> names;
    for (const auto& [name, joints] : parameters.postures) names.push_back(name);
    refuse_word("posture", order.posture, names);
  }
  command.kind = CommandKind::joint;
  command.joints = posture->second;
}

void fill_tool(const RobotOrder& order, const RobotParameters& parameters, RobotCommand& command) {
  const auto tool = parameters.tools.find(order.tool);
  if (tool == parameters.tools.end()) {
    std::vector<std::string> names;
    for (const auto& [name, pose] : parameters.tools) names.push_back(name);
    refuse_word("tool", order.tool, names);
  }
  command.kind = CommandKind::set_tool;
  command.pose = tool->second;
}

/// Digital outputs are "0".."15", analogue ones "a0".."a7".
void fill_output(const RobotOrder& order, RobotCommand& command) {
  command.kind = CommandKind::set_outputs;
  const bool analogue = order.axis.starts_with('a');
  const auto number = core::to_finite(analogue ? order.axis.substr(1) : order.axis);
  const int count = analogue ? ControllerIo::kAnalog : ControllerIo::kDigital;
  if (!number || *number < 0 || *number >= count || *number != std::floor(*number))
    refuse("output", in_quotes(order.axis) + " is unknown", "0 to 15 for a digital one, a0 to a7 for an analogue one");
  const auto index = static_cast<int>(*number);
  command.choice = static_cast<std::uint8_t>(analogue ? ControllerIo::kDigital + index : index);
  if (analogue) {
    command.outputs.analog[static_cast<std::size_t>(index)] = order.amount;
    return;
  }
  if (order.amount != 0 && order.amount != 1) refuse("value", number_text(order.amount), "0 or 1 of a digital output");
  command.outputs.set(index, order.amount == 1);
}

}  // namespace

bool is_robot_order(std::string_view command) noexcept {
  return std::find(std::begin(kOrders), std::end(kOrders), command) != std::end(kOrders);
}

std::vector<std::string> order_frames() { return {"axes", "base", "tool", "motors"}; }

RobotParameters parameters_of(const RobotEntry& robot) {
  return read_robot_parameters(Table::load(robot.files().parameters));
}

RobotCommand command_of(const std::string& command, const RobotOrder& order, const RobotParameters& parameters) {
  if (!std::isfinite(order.amount)) refuse("value", number_text(order.amount), "a finite number");
  RobotCommand result;
  if (command == "jog" || command == "step") {
    const std::vector<std::string> frames = order_frames();
    if (std::find(frames.begin(), frames.end(), order.frame) == frames.end()) refuse_word("in", order.frame, frames);
    command == "jog" ? fill_jog(order, parameters, result) : fill_step(order, parameters, result);
  } else if (command == "go") {
    fill_go(order, parameters, result);
  } else if (command == "tool") {
    fill_tool(order, parameters, result);
  } else if (command == "output") {
    fill_output(order, result);
  } else {
    result.kind = command == "hold"          ? CommandKind::hold
                  : command == "synchronise" ? CommandKind::synchronise
                  : command == "recover"     ? CommandKind::recover
                                             : CommandKind::bias_force;
  }
  return result;
}

RobotOrder read_robot_order(const Table& table, const std::string& command, const Deployment& deployment) {
  std::vector<std::string> robots;
  for (const RobotEntry& robot : deployment.robots) robots.push_back(robot.name);
  RobotOrder order;
  order.robot = table.choice("robot", robots);
  if (command == "jog" || command == "step") {
    order.axis = table.text("axis");
    order.frame = table.has("in") ? table.choice("in", order_frames()) : "axes";
    order.amount = table.number(command == "jog" ? "velocity" : "distance");
  } else if (command == "go") {
    order.posture = table.text("posture");
  } else if (command == "tool") {
    order.tool = table.text("tool");
  } else if (command == "output") {
    order.axis = table.text("output");
    order.amount = table.number("value");
  }
  try {
    command_of(command, order, parameters_of(deployment.robot(order.robot)));
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    const std::string key = what.substr(0, what.find(':'));
    table.fail(key, what.substr(key.size() + 2), "");
  }
  return order;
}

}  // namespace mrroc::config
