#include "sensors/force_torque/force_torque_sensor.hpp"

#include <cmath>

#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

namespace {

Wrench support(const RawReading& r) noexcept { return Eigen::Map<const Wrench>(r.values.data()); }

}  // namespace

std::vector<Channel> ForceTorqueSensor::channels() const {
  return {{"force_x", "N"},    {"force_y", "N"},    {"force_z", "N"},
          {"torque_x", "N m"}, {"torque_y", "N m"}, {"torque_z", "N m"}};
}

std::vector<Channel> ForceTorqueSensor::raw_channels() const {
  return {{"support_force_x", "N"},    {"support_force_y", "N"},    {"support_force_z", "N"},
          {"support_torque_x", "N m"}, {"support_torque_y", "N m"}, {"support_torque_z", "N m"}};
}

void ForceTorqueSensor::configure(const config::SensorEntry& entry, double servo_period) {
  range_ << vector3(entry, "force_range"), vector3(entry, "torque_range");
  force_noise_ = number(entry, "force_noise");
  torque_noise_ = number(entry, "torque_noise");
  tool_mass_ = number(entry, "tool_mass");
  tool_centre_ = vector3(entry, "tool_centre");
  gravity_ = vector3(entry, "gravity");
  noise_ = Noise{entry.name};
  const double cutoff = number(entry, "cutoff");
  if (cutoff > 0.5 / servo_period) {
    refuse(entry, "cutoff", std::to_string(cutoff) + " Hz",
           "at most " + std::to_string(0.5 / servo_period) + " Hz, half the servo rate");
  }
  filter_.configure(cutoff, servo_period);
  if (tool_mass_ > 0 && entry.robot.empty()) {
    refuse(entry, "tool_mass", "a sensor of no robot", "the key 'robot' beside it, whose pose turns the tool");
  }
}

void ForceTorqueSensor::effector_state(const RobotState& e) noexcept {
  tool_orientation_.reset();  // a robot that has lost its synchronisation has no pose
  if (e.synchronised) tool_orientation_ = e.pose.linear();
}

void ForceTorqueSensor::track(const RawReading& r) noexcept {
  if (usable(r)) filter_.update(r.tick, -support(r) - tool_weight() + noise(r.tick));
}

void ForceTorqueSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  if (const std::optional<int> i = beyond_range(r)) {
    static constexpr std::array<const char*, 6> kNames{"force x",  "force y",  "force z",
                                                       "torque x", "torque y", "torque z"};
    const auto axis = static_cast<std::size_t>(*i);
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_out_of_range, "%s %g %s, expected at most %g",
                  kNames[axis], -r.values[axis], *i < 3 ? "N" : "N m", range_[*i]);
  }
  if (weight_unknown()) {
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_not_ready,
                  "the tool's weight needs the pose of a synchronised robot");
  }
  track(r);
  Eigen::Map<Wrench>(v.values.data()) = filter_.value() - bias_;
}

bool ForceTorqueSensor::bias(const RawReading& r) noexcept {
  if (usable(r)) {
    track(r);
    bias_ = filter_.value();
  }
  return true;
}

std::optional<int> ForceTorqueSensor::beyond_range(const RawReading& r) const noexcept {
  for (int i = 0; i < 6; ++i) {
    if (std::abs(r.values[static_cast<std::size_t>(i)]) > range_[i]) return i;
  }
  return std::nullopt;
}

Wrench ForceTorqueSensor::tool_weight() const noexcept {
  Wrench weight = Wrench::Zero();
  if (tool_mass_ > 0) {
    const Eigen::Vector3d force = tool_orientation_->transpose() * (tool_mass_ * gravity_);
    weight << force, tool_centre_.cross(force);
  }
  return weight;
}

Wrench ForceTorqueSensor::noise(Tick tick) const noexcept {
  Wrench noise = Wrench::Zero();
  for (int i = 0; i < 6; ++i) {
    const double deviation = i < 3 ? force_noise_ : torque_noise_;
    if (deviation > 0) noise[i] = deviation * noise_.normal(tick, static_cast<std::uint32_t>(i));
  }
  return noise;
}

}  // namespace mrroc::vsp
