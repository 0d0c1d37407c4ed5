#include "edp/force/wrist_sensor.hpp"

#include "geometry/rigid_motion.hpp"
#include "vsp/make_source.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::edp {
WristSensor::WristSensor(const vsp::SourceContext& context)
    : mount_(pose_from_rpy(vsp::vector3(context.entry, "position"), vsp::vector3(context.entry, "rotation"))) {
  sensor_.set_up(context.entry, context.servo_period);
  source_ = vsp::make_source(sensor_, context);
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
  sensor_.effector_state(effector_state_);
  SensorReading reading;
  sensor_.aggregate(raw_, reading);
  result.error = reading.error.code;
  if (result.error == ErrorCode::none)
    result.wrench = Eigen::Map<const Wrench>(reading.values.data());
  else if (result.error == ErrorCode::sensor_out_of_range)
    result.wrench = sensor_.load(raw_);
  return result;
}

}  // namespace mrroc::edp
