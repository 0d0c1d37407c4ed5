#include "sim/simulation.hpp"

#include <algorithm>

#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"

namespace mrroc::sim {

namespace {

bool in_world(const config::RobotEntry& robot) { return robot.hardware == "mujoco"; }

bool in_world(const config::SensorEntry& sensor) { return sensor.source == "simulated"; }

const config::SimEntry& sim_entry(const config::Deployment& deployment) {
  if (!deployment.sim) throw config::ConfigurationError(deployment.file, 0, "sim", "missing", "a table [sim]");
  if (deployment.robots.size() > kMaxRobots || deployment.sensors.size() > kMaxSensors) {
    throw config::ConfigurationError(
        deployment.file, 0, "", "too many robots or sensors",
        "at most " + std::to_string(kMaxRobots) + " robots and " + std::to_string(kMaxSensors) + " sensors");
  }
  return *deployment.sim;
}

}  // namespace

Composition compose(const config::Deployment& deployment) {
  std::vector<RobotPart> parts;
  for (const config::RobotEntry& robot : deployment.robots) {
    if (!in_world(robot)) continue;
    const bool force_torque =
        std::any_of(deployment.sensors.begin(), deployment.sensors.end(), [&](const config::SensorEntry& sensor) {
          return in_world(sensor) && sensor.type == "force_torque" && sensor.robot == robot.name;
        });
    parts.push_back(
        {robot.name, config::robot_file(robot.type, robot.type + ".xml"), robot.base, force_torque, robot.mount});
  }
  return compose(sim_entry(deployment).scene, parts);
}

Simulation::Simulation(const config::Deployment& deployment, WorldMemory& memory)
    : memory_(memory), world_(compose(deployment), deployment.servo_period, sim_entry(deployment).timestep) {
  for (std::size_t i = 0; i < deployment.robots.size(); ++i) {
    const config::RobotEntry& robot = deployment.robots[i];
    if (!in_world(robot)) continue;
    const auto file = config::robot_file(robot.type, robot.type + ".toml");
    const RobotParameters parameters = config::read_robot_parameters(config::Table::load(file));
    std::vector<std::string> joints;
    for (const AxisParameters& axis : parameters.axes) joints.push_back(axis.name);
    robots_.push_back({i, world_.attach(robot.name, joints, parameters.home)});
  }
  for (std::size_t j = 0; j < deployment.sensors.size(); ++j) {
    const config::SensorEntry& sensor = deployment.sensors[j];
    if (!in_world(sensor)) continue;
    sensors_.push_back({j, SensorSource(world_.model(), sensor.name, sensor.type, sensor.robot)});
  }
  world_.start();
}

void Simulation::publish_initial() { publish(0); }

void Simulation::step(Tick tick) {
  for (const Slot& slot : robots_) take_drive(slot, tick);
  world_.step(tick);
  publish(tick);
}

void Simulation::take_drive(const Slot& slot, Tick tick) {
  JointDrive drive;
  const bool present = memory_.drives[slot.memory].load(drive) && drive.tick > 0;
  if (present) world_.set_outputs(slot.world, drive.outputs);
  if (present && drive.enabled != 0 && tick <= drive.tick + kDriveLifetime) {
    world_.drive(slot.world, drive, tick);
  } else {
    world_.brake(slot.world);
  }
}

void Simulation::publish(Tick tick) {
  tick_ = tick;
  for (const Slot& slot : robots_) {
    JointMeasurement measurement{};
    measurement.tick = tick;
    world_.measure(slot.world, measurement);
    memory_.measurements[slot.memory].store(measurement);
  }
  for (const SensorSlot& slot : sensors_) {
    HardwareReading reading{};
    reading.tick = tick;
    slot.source.read(world_.data(), reading);
    memory_.readings[slot.memory].store(reading);
  }
}

WorldState Simulation::state() const {
  const mjData& data = world_.data();
  return {tick_, data.time, {data.qpos, data.qpos + world_.model().nq}};
}

}  // namespace mrroc::sim
