#include "sensors/force_torque/force_torque_sensor.hpp"

#include <cmath>

#include "geometry/rigid_motion.hpp"
#include "language/limits.hpp"
#include "sensors/force_torque/simulated_gauges.hpp"
#include "vsp/configuration.hpp"
#include "vsp/make_source.hpp"
#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"
#include "vsp/simulated_source.hpp"

namespace mrroc::vsp {

namespace {

// bounds of a load: beyond them a unit is wrong
constexpr double kMostMass = 1000;      // kg
constexpr double kMostDistance = 10.0;  // m

/// The six values of r: a supporting wrench or voltages.
Eigen::Map<const Wrench> six_values(const RawReading& r) noexcept { return Eigen::Map<const Wrench>(r.values.data()); }

}  // namespace

std::vector<Channel> ForceTorqueSensor::raw_channels() const {
  if (gauges_)
    return {{"gauge_0", "V"}, {"gauge_1", "V"}, {"gauge_2", "V"}, {"gauge_3", "V"}, {"gauge_4", "V"}, {"gauge_5", "V"}};
  return VirtualSensor::raw_channels();
}

void ForceTorqueSensor::configure(const config::SensorEntry& entry, double servo_period) {
  range_ << vector3(entry, "force_range"), vector3(entry, "torque_range");
  force_noise_ = number(entry, "force_noise");
  torque_noise_ = number(entry, "torque_noise");
  zero_ = Eigen::Map<const Wrench>(entry.numbers.at("zero").data());
  tool_mass_ = number(entry, "tool_mass");
  tool_centre_ = vector3(entry, "tool_centre");
  servo_period_ = servo_period;
  follows_ = entry.wants_effector_state && !entry.robot.empty();
  gravity_ = vector3(entry, "gravity");
  noise_ = Noise{entry.name};
  gauges_ = Gauges::of(entry);
  mount_ = pose_from_rpy(vector3(entry, "position"), vector3(entry, "rotation"));
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

std::unique_ptr<Source> ForceTorqueSensor::open_source(const SourceContext& context) {
  if (!gauges_ || context.entry.source != "simulated" || context.world == nullptr) return nullptr;
  const auto silent_after = static_cast<Tick>(std::ceil(kSilentAfter / context.servo_period));
  return std::make_unique<SimulatedGauges>(
      *gauges_, std::make_unique<SimulatedSource>(*context.world, context.slot, silent_after));
}

void ForceTorqueSensor::effector_state(const RobotState& e) noexcept {
  orientation_.reset();  // a robot that has lost its synchronisation has no pose
  if (e.synchronised) orientation_ = e.pose.linear() * e.tool.linear().transpose() * mount_.linear();
}

void ForceTorqueSensor::track(const RawReading& r) noexcept {
  if (measurable(r) && !weight_unknown()) filter_.update(r.tick, load(r) - weight() + noise(r.tick));
}

void ForceTorqueSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  if (!measurable(r)) return report_out_of_range(r, v);
  if (weight_unknown()) {
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_not_ready,
                  "the tool's weight needs the pose of a synchronised robot");
  }
  track(r);
  Eigen::Map<Wrench>(v.values.data()) = filter_.value() - bias_;
}

bool ForceTorqueSensor::bias(const RawReading& r) noexcept {
  if (measurable(r) && !weight_unknown()) {
    track(r);
    bias_ = filter_.value();
  }
  return true;
}

void ForceTorqueSensor::reconfigure(const Message& configuration) {
  take_configuration<Carrying, LowPassAt>(configuration, [this](const auto& taken) { apply(taken); });
}

void ForceTorqueSensor::apply(const Carrying& carrying) {
  check_configured("Carrying", "mass", carrying.mass, 0, kMostMass, "kg");
  for (const double coordinate : carrying.centre)
    check_configured("Carrying", "centre", coordinate, -kMostDistance, kMostDistance, "m");
  if (carrying.mass > 0 && !follows_)
    refuse_configuration("Carrying", "mass", carrying.mass,
                         "0 kg: the deployment gives this sensor no robot and tool_mass, so it does not know how the "
                         "load is turned");
  carry({carrying.mass, carrying.centre});
}

void ForceTorqueSensor::apply(const LowPassAt& low_pass) {
  check_configured("LowPassAt", "cutoff", low_pass.cutoff, 0, 0.5 / servo_period_, "Hz, half the servo rate");
  filter_.configure(low_pass.cutoff, servo_period_);
}

void ForceTorqueSensor::carry(const Load& carried) noexcept {
  const Wrench before = orientation_ ? weight() : Wrench::Zero();
  carried_ = carried;
  if (orientation_) filter_.shift(before - weight());
}

Wrench ForceTorqueSensor::load(const RawReading& r) const noexcept {
  return (gauges_ ? gauges_->load(six_values(r)) : Wrench{-six_values(r)}) - zero_;
}

std::optional<int> ForceTorqueSensor::saturated_gauge(const RawReading& r) const noexcept {
  return gauges_ ? gauges_->saturated(six_values(r)) : std::nullopt;
}

std::optional<int> ForceTorqueSensor::beyond_range(const Wrench& load) const noexcept {
  for (int i = 0; i < 6; ++i) {
    if (std::abs(load[i]) > range_[i]) return i;
  }
  return std::nullopt;
}

void ForceTorqueSensor::report_out_of_range(const RawReading& r, SensorReading& v) const noexcept {
  if (const std::optional<int> gauge = saturated_gauge(r)) {
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_out_of_range,
                  "gauge %d is saturated at %g V, expected less than %g", *gauge,
                  r.values[static_cast<std::size_t>(*gauge)], gauges_->limit());
  }
  static constexpr std::array<const char*, 6> kNames{"force x",  "force y",  "force z",
                                                     "torque x", "torque y", "torque z"};
  const Wrench wrench = load(r);
  const int axis = beyond_range(wrench).value_or(0);
  const int digits = digits_to_differ(std::abs(wrench[axis]), range_[axis]);
  report(v, ErrorClass::non_fatal, ErrorCode::sensor_out_of_range, "%s %.*g %s, expected at most %.*g",
         kNames[static_cast<std::size_t>(axis)], digits, wrench[axis], axis < 3 ? "N" : "N m", digits, range_[axis]);
}

/// Of the tool and what it carries.
Wrench ForceTorqueSensor::weight() const noexcept {
  Wrench weight = Wrench::Zero();
  if (tool_mass_ > 0) {
    const Eigen::Vector3d force = orientation_->transpose() * (tool_mass_ * gravity_);
    weight << force, tool_centre_.cross(force);
  }
  if (carried_.mass > 0) weight += weight_of(carried_, *orientation_, gravity_);
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
