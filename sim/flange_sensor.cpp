#include "sim/flange_sensor.hpp"

#include <Eigen/Geometry>

#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::sim {

namespace {

using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Map<const Eigen::Vector3d> vector_at(const mjtNum* values, int index) {
  return Eigen::Map<const Eigen::Vector3d>(values + std::ptrdiff_t{3} * index);
}

Eigen::Map<const Rotation> rotation_at(const mjtNum* values, int index) {
  return Eigen::Map<const Rotation>(values + std::ptrdiff_t{9} * index);
}

bool is_behind(const mjModel& model, int body, int first) {
  for (; body > 0; body = model.body_parentid[body])
    if (body == first) return true;
  return false;
}

int find_sensor(const mjModel& model, const std::string& name) {
  const int sensor = mj_name2id(&model, mjOBJ_SENSOR, name.c_str());
  if (sensor >= 0) return sensor;
  throw config::ConfigurationError({}, 0, "sensors", "the simulated world has no sensor " + config::in_quotes(name),
                                   "a site \"wrist\" in the robot's MJCF, or this sensor there");
}

}  // namespace

FlangeSensor::FlangeSensor(const mjModel& model, const std::string& robot) {
  const int force = find_sensor(model, robot + "/force_torque/force");
  const int torque = find_sensor(model, robot + "/force_torque/torque");
  base_ = mj_name2id(&model, mjOBJ_BODY, robot.c_str());
  site_ = model.sensor_objid[force];
  force_ = model.sensor_adr[force];
  torque_ = model.sensor_adr[torque];
  for (int body = 1; body < model.nbody; ++body) {
    const std::string name = model.names + model.name_bodyadr[body];
    if (name.starts_with(robot + "/") && is_behind(model, body, model.site_bodyid[site_])) bodies_.push_back(body);
  }
}

void FlangeSensor::measure(const mjModel& model, const mjData& data,
                           world::FlangeMeasurement& measurement) const noexcept {
  const Rotation base = rotation_at(data.xmat, base_), flange = rotation_at(data.site_xmat, site_);
  const Eigen::Vector3d origin = vector_at(data.site_xpos, site_);
  Eigen::Map<Eigen::Vector3d>(measurement.position.data()) = base.transpose() * (origin - vector_at(data.xpos, base_));
  Eigen::Map<Rotation>(measurement.rotation.data()) = base.transpose() * flange;
  Eigen::Map<Eigen::Vector3d> force(measurement.load.data()), torque(measurement.load.data() + 3);
  force = -vector_at(data.sensordata + force_, 0);
  torque = -vector_at(data.sensordata + torque_, 0);
  const Eigen::Vector3d gravity = flange.transpose() * vector_at(model.opt.gravity, 0);
  for (const int body : bodies_) {
    const Eigen::Vector3d weight = model.body_mass[body] * gravity;
    force -= weight;
    torque -= (flange.transpose() * (vector_at(data.xipos, body) - origin)).cross(weight);
  }
}

}  // namespace mrroc::sim
