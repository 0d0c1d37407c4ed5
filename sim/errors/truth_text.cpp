#include "sim/errors/truth_text.hpp"

#include <array>
#include <cstdio>

#include "config/robot_parameters_file.hpp"
#include "geometry/rigid_motion.hpp"
#include "sim/errors/true_errors.hpp"

namespace mrroc::sim {

namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

template <class Values>
std::string list(const Values& values) {
  std::string text;
  for (const double value : values) text.append(text.empty() ? "[" : ", ").append(number(value));
  return text + "]";
}

/// "position = [...]<between>rotation = [...]" with this prefix of both keys.
std::string frame(const Pose& error, const std::string& prefix, const std::string& between) {
  return prefix + "position = " + list(error.translation()) + between + prefix +
         "rotation = " + list(rpy_of(error.linear()));
}

std::string links_of(const config::ErrorsEntry& errors, const std::string& robot, const mjModel& model) {
  std::string text;
  for (int body = 0; body < model.nbody; ++body) {
    const std::string name = model.names + model.name_bodyadr[body];
    if (!name.starts_with(robot + "/") || model.body_jntnum[body] == 0 ||
        model.jnt_type[model.body_jntadr[body]] == mjJNT_FREE)
      continue;
    const std::string link = name.substr(robot.size() + 1);
    text += "\"" + link + "\" = { " + frame(error_of_link(errors, robot, link), "", ", ") + " }\n";
  }
  return text;
}

std::string joints_of(const config::ErrorsEntry& errors, const config::RobotEntry& robot) {
  std::string text;
  const RobotParameters parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
  for (const AxisParameters& axis : parameters.axes) {
    const TrueJoint joint = errors_of_joint(errors, robot.name, axis.name);
    text += "\"" + axis.name + "\" = { offset = " + number(joint.offset) + ", gear = " + number(joint.gear) +
            ", amplitude = " + number(joint.amplitude) + ", phase = " + number(joint.phase) +
            ", backlash = " + number(joint.backlash) + ", friction = " + number(joint.friction) + " }\n";
  }
  return text;
}

std::string sensor_text(const config::ErrorsEntry& errors, const config::SensorEntry& sensor) {
  if (sensor.type == "force_torque") {
    const TrueWrench wrench = error_of_wrench(errors, sensor.name);
    return "bias = " + list(wrench.bias) + "  # N, N m\ndrift = " + list(wrench.drift) + "  # N/s, N m/s\n";
  }
  if (!sensor.texts.contains("camera")) return "";
  const TrueLens lens = error_of_lens(errors, sensor.name);
  return frame(error_of_camera(errors, sensor.name), "", "  # m\n") + "  # rad, rpy\nfocal = " + number(lens.focal) +
         "\nk1 = " + number(lens.k1) + "\n";
}

}  // namespace

std::string truth_text(const config::Deployment& deployment, const mjModel& model) {
  const config::ErrorsEntry& errors = *deployment.sim->errors;
  std::string text = "# Errors drawn for this world: docs/reference/simulated-errors.md\nseed = ";
  text += std::to_string(errors.seed) + "\n";
  for (const config::RobotEntry& robot : deployment.robots) {
    if (!robot.in_world()) continue;
    const std::string table = "robots." + robot.name;
    text += "\n[" + table + "]\n" + frame(error_of_base(errors, robot.name), "base_", "  # m\n") + "  # rad, rpy\n";
    text += "[" + table + ".links]\n" + links_of(errors, robot.name, model);
    text += "[" + table + ".joints]\n" + joints_of(errors, robot);
  }
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (const std::string drawn = sensor.in_world() ? sensor_text(errors, sensor) : ""; !drawn.empty())
      text.append("\n[sensors.").append(sensor.name).append("]\n").append(drawn);
  return text;
}

}  // namespace mrroc::sim
