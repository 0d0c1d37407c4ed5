#include "sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "sim/errors/true_errors.hpp"

namespace mrroc::sim {

namespace {

bool in_world(const config::RobotEntry& robot) { return robot.in_world(); }

bool in_world(const config::SensorEntry& sensor) { return sensor.in_world(); }

/// Whether the robot's simulated controller measures the load on its flange.
bool measures_flange(const config::Deployment& deployment, const config::RobotEntry& robot) {
  return std::any_of(deployment.sensors.begin(), deployment.sensors.end(), [&](const config::SensorEntry& sensor) {
    return in_world(sensor) && sensor.robot == robot.name && sensor.driver && !sensor.driver->controller.empty();
  });
}

bool looks_at_world(const config::SensorEntry& sensor) { return sensor.texts.contains("camera"); }

std::size_t snapshot_values(const mjModel& model) {
  return static_cast<std::size_t>(model.nq) + 7 * static_cast<std::size_t>(model.nmocap);
}

void check_snapshot(const mjModel& model, const config::SensorEntry& sensor) {
  const std::size_t count = snapshot_values(model);
  if (count <= world::kMaxSnapshotValues) return;
  throw config::ConfigurationError({}, 0, "sensors." + sensor.name,
                                   "views a world with " + std::to_string(count) + " positions",
                                   "at most " + std::to_string(world::kMaxSnapshotValues));
}

/// A missing input is off, like a cut wire: the emergency stop would be pressed permanently.
void check_emergency_stop(const mjModel& model, const config::Deployment& deployment, const config::RobotEntry& robot) {
  if (!robot.emergency_stop) return;
  const std::string input = "input_" + std::to_string(*robot.emergency_stop);
  const std::string sensor = robot.name + "/" + input;
  if (mj_name2id(&model, mjOBJ_SENSOR, sensor.c_str()) >= 0) return;
  throw config::ConfigurationError(deployment.file, 0, "robots." + robot.name + ".emergency_stop",
                                   input + " is not in the scene, so that it would be pressed permanently",
                                   "a sensor " + config::in_quotes(sensor) + " there or in the robot's MJCF");
}

const config::SimEntry& sim_entry(const config::Deployment& deployment) {
  if (!deployment.sim) throw config::ConfigurationError(deployment.file, 0, "sim", "missing", "a table [sim]");
  if (deployment.robots.size() > world::kMaxRobots || deployment.sensors.size() > world::kMaxSensors) {
    throw config::ConfigurationError(deployment.file, 0, "", "too many robots or sensors",
                                     "at most " + std::to_string(world::kMaxRobots) + " robots and " +
                                         std::to_string(world::kMaxSensors) + " sensors");
  }
  return *deployment.sim;
}

/// The robots that are `shown`.
std::vector<RobotPart> parts_of(const config::Deployment& deployment, bool (*shown)(const config::RobotEntry& robot)) {
  std::vector<RobotPart> parts;
  for (const config::RobotEntry& robot : deployment.robots) {
    if (!shown(robot)) continue;
    const bool force_torque =
        std::any_of(deployment.sensors.begin(), deployment.sensors.end(), [&](const config::SensorEntry& sensor) {
          return in_world(sensor) && sensor.type == "force_torque" && sensor.robot == robot.name;
        });
    parts.push_back({robot.name, robot.files().mjcf, robot.base, force_torque, robot.mount});
    if (!deployment.sim || !deployment.sim->errors) continue;
    parts.back().base = robot.base * error_of_base(*deployment.sim->errors, robot.name);
    parts.back().errors = deployment.sim->errors;
  }
  return parts;
}

}  // namespace

Composition compose(const config::Deployment& deployment) {
  return compose(sim_entry(deployment).scene, parts_of(deployment, in_world));
}

Composition compose_all(const config::Deployment& deployment) {
  const std::vector<RobotPart> parts = parts_of(deployment, [](const config::RobotEntry&) { return true; });
  return compose(deployment.sim ? deployment.sim->scene : config::type_file("panel", "scene", "empty.xml"), parts);
}

Simulation::Simulation(const config::Deployment& deployment, world::WorldMemory& memory)
    : memory_(memory), world_(compose(deployment), deployment.servo_period, sim_entry(deployment).timestep) {
  for (std::size_t i = 0; i < deployment.robots.size(); ++i) {
    const config::RobotEntry& robot = deployment.robots[i];
    if (!in_world(robot)) continue;
    check_emergency_stop(world_.model(), deployment, robot);
    const RobotParameters parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
    std::vector<std::string> joints;
    for (const AxisParameters& axis : parameters.axes) joints.push_back(axis.name);
    robots_.push_back({.memory = i, .world = world_.attach(robot.name, joints, parameters.home)});
    if (const auto& errors = deployment.sim->errors)
      robots_.back().transmission.emplace(*errors, robot.name, parameters);
    if (measures_flange(deployment, robot)) flanges_.push_back({i, FlangeSensor(world_.model(), robot.name)});
  }
  for (std::size_t j = 0; j < deployment.sensors.size(); ++j) {
    const config::SensorEntry& sensor = deployment.sensors[j];
    if (!in_world(sensor)) continue;
    if (looks_at_world(sensor)) {
      check_snapshot(world_.model(), sensor);
      looked_at_ = true;
      continue;
    }
    sensors_.push_back({j, SensorSource(world_.model(), sensor.name, sensor.type, sensor.robot)});
    if (const auto& errors = deployment.sim->errors)
      sensors_.back().errors.emplace(*errors, sensor, deployment.servo_period);
  }
  for (const config::FeederEntry& feeder : deployment.sim->feeders) {
    feeders_.emplace_back(feeder, world_, deployment.servo_period);
  }
  if (const auto& errors = deployment.sim->errors; errors && looked_at_)
    if (const std::size_t latency = latency_of_cameras(*errors, deployment.servo_period); latency > 0)
      delayed_.emplace(latency);
  may_be_watched_ = snapshot_values(world_.model()) <= world::kMaxSnapshotValues;
  world_.start();
}

void Simulation::publish_initial() {
  publish(0);
  memory_.measured.open();
}

void Simulation::step(Tick tick) {
  for (Feeder& feeder : feeders_) feeder.feed(world_, tick - 1);
  for (Slot& slot : robots_) take_drive(slot, tick);
  world_.step(tick);
  publish(tick);
}

void Simulation::step_in_real_time(Tick tick, double patience) {
  const auto due = [&](Slot& slot) { return is_due(slot, tick); };
  const auto all_there = [&] { return std::none_of(robots_.begin(), robots_.end(), due); };
  if (!memory_.driven.wait(all_there, std::llround(patience * 1e9))) {
    for (Slot& slot : robots_)
      if (is_due(slot, tick)) slot.given_up = slot.drive.tick;
  }
  step(tick);
  memory_.measured.open();
}

/// Whether the robot's newest drive acts in tick `tick`; else its brakes are on.
bool Simulation::drives(const Slot& slot, Tick tick) const noexcept {
  const world::JointDrive& drive = slot.drive;
  return drive.tick > 0 && drive.enabled != 0 && drive.tick != slot.given_up && tick <= drive.tick + kDriveLifetime;
}

/// Whether the robot's drive of the tick before `tick` has not come yet.
bool Simulation::is_due(Slot& slot, Tick tick) noexcept {
  memory_.drives[slot.memory].load(slot.drive);  // during a write the previous drive stays
  return drives(slot, tick) && slot.drive.tick + 1 < tick;
}

bool Simulation::driven() const noexcept {
  return std::any_of(robots_.begin(), robots_.end(), [this](const Slot& slot) { return drives(slot, tick_); });
}

void Simulation::take_drive(Slot& slot, Tick tick) {
  memory_.drives[slot.memory].load(slot.drive);
  if (slot.drive.tick > 0) world_.set_outputs(slot.world, slot.drive.outputs);
  if (!drives(slot, tick)) {
    world_.brake(slot.world);
  } else if (slot.transmission) {
    world::JointDrive drive = slot.drive;
    slot.transmission->act(drive, tick);
    world_.drive(slot.world, drive, tick);
    world_.set_friction(slot.world, slot.transmission->friction(drive));
  } else {
    world_.drive(slot.world, slot.drive, tick);
  }
}

void Simulation::publish(Tick tick) {
  tick_ = tick;
  for (const SensorSlot& slot : sensors_) {
    RawReading reading{};
    reading.tick = tick;
    slot.source.read(world_.data(), reading);
    if (slot.errors) slot.errors->apply(reading);
    memory_.readings[slot.memory].store(reading);
  }
  if (looked_at_ || (may_be_watched_ && memory_.watched.load(std::memory_order_relaxed) != 0)) store_snapshot(tick);
  for (const FlangeSlot& slot : flanges_) {
    world::FlangeMeasurement measurement{};
    measurement.tick = tick;
    slot.sensor.measure(world_.model(), std::as_const(world_).data(), measurement);
    memory_.flanges[slot.memory].store(measurement);
  }
  // last: a servo that sees them also reads its force sensor
  for (Slot& slot : robots_) {
    world::JointMeasurement measurement{};
    measurement.tick = tick;
    world_.measure(slot.world, measurement);
    if (slot.transmission) slot.transmission->report(measurement);
    memory_.measurements[slot.memory].store(measurement);
  }
}

void Simulation::store_snapshot(Tick tick) noexcept {
  const mjModel& model = world_.model();
  const mjData& data = std::as_const(world_).data();
  snapshot_.tick = tick;
  snapshot_.position_count = static_cast<std::uint32_t>(model.nq);
  snapshot_.mocap_count = static_cast<std::uint32_t>(model.nmocap);
  double* values = std::copy_n(data.qpos, model.nq, snapshot_.values.data());
  values = std::copy_n(data.mocap_pos, 3 * model.nmocap, values);
  std::copy_n(data.mocap_quat, 4 * model.nmocap, values);
  memory_.snapshot.store(snapshot_);
  if (!delayed_) return;
  delayed_->put(snapshot_);
  memory_.seen.store(snapshot_);
}

WorldState Simulation::state() const {
  const mjData& data = world_.data();
  return {tick_, data.time, {data.qpos, data.qpos + world_.model().nq}};
}

}  // namespace mrroc::sim
