#include "edp/force/wrist_sensor.hpp"

#include "vsp/make_source.hpp"

namespace mrroc::edp {

WristSensor::WristSensor(std::unique_ptr<vsp::WrenchSource> sensor, const vsp::SourceContext& context)
    : sensor_(std::move(sensor)) {
  sensor_->set_up(context.entry, context.servo_period);
  mount_ = sensor_->mount();
  source_ = vsp::make_source(*sensor_, context);
}

std::unique_ptr<vsp::WrenchSource> load_wrench_source(const config::SensorEntry& entry) {
  const plugin::Interface& library = plugin::load(entry.wrench_library, vsp::wrench_source_interface(nullptr));
  return reinterpret_cast<vsp::MakeWrenchSource>(library.make)();
}

WrenchReading WristSensor::read(Tick tick, const Pose* flange) noexcept {
  WrenchReading result;
  raw_ = {};
  switch (source_->read(tick, raw_)) {
    case vsp::SourceState::not_ready:
      return result;
    case vsp::SourceState::silent:
    case vsp::SourceState::faulty:
      result.error = ErrorCode::sensor_hardware;
      return result;
    case vsp::SourceState::ready:
      break;
  }
  if (raw_.count < 6 || !Eigen::Map<const Wrench>(raw_.values.data()).allFinite()) {
    result.error = ErrorCode::sensor_hardware;
    return result;
  }
  effector_state_.synchronised = flange != nullptr;
  if (flange != nullptr) effector_state_.pose = *flange;  // a robot without a tool
  sensor_->effector_state(effector_state_);
  SensorReading reading;
  sensor_->aggregate(raw_, reading);
  result.error = reading.error.code;
  if (result.error == ErrorCode::none)
    result.wrench = Eigen::Map<const Wrench>(reading.values.data());
  else if (result.error == ErrorCode::sensor_out_of_range)
    result.wrench = sensor_->load(raw_);
  return result;
}

}  // namespace mrroc::edp
