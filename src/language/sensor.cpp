#include "mrroc/sensor.hpp"

#include <limits>

#include "mrroc/task.hpp"

namespace mrroc {

Sensor::Sensor(Task& task, const std::string& name, const std::string& type)
    : task_(&task), name_(name), link_(&task.sensor_link(name, type, interactive_)) {}

double Sensor::value(std::size_t channel) const noexcept {
  return channel < reading_.channel_count ? reading_.values[channel] : std::numeric_limits<double>::quiet_NaN();
}

void Sensor::set_period(std::uint32_t steps) {
  if (steps == 0) {
    throw NonFatalError(ErrorCode::invalid_argument, "sensor period 0 steps, expected at least 1",
                        {task_->process_name(), name_, 0, 0});
  }
  period_ = steps;
}

void Sensor::bias() {
  if (!interactive_) {
    throw NonFatalError(ErrorCode::invalid_argument, "bias needs a sensor in interactive mode",
                        {task_->process_name(), name_, 0, 0});
  }
  asked_ = false;  // the reply to an overtaken request is not awaited
  link_->request({SensorRequestKind::bias, 0});
  link_->receive(reading_);
  const ErrorReport& error = reading_.error;
  if (error.error_class != ErrorClass::none) {
    throw_error(error.error_class, error.code, std::string{error.detail.view()},
                {task_->process_name(), name_, 0, reading_.tick});
  }
}

void Sensor::configure_with(const Message& configuration) {
  if (in_use_)
    throw NonFatalError(ErrorCode::busy, "another fiber reads this sensor", {task_->process_name(), name_, 0, 0});
  asked_ = false;  // the reply to an overtaken request is not awaited
  link_->request({SensorRequestKind::configure, 0, configuration});
  SensorReading answer;
  link_->receive(answer);
  const ErrorReport& error = answer.error;
  if (error.error_class != ErrorClass::none) {
    throw_error(error.error_class, error.code, std::string{error.detail.view()},
                {task_->process_name(), name_, 0, answer.tick});
  }
  configuration_ = answer.configuration;
  reading_ = SensorReading{};
  reading_.configuration = configuration_;
  fresh_ = false;
}

double Sensor::age() const noexcept {
  if (reading_.sequence == 0) return std::numeric_limits<double>::infinity();
  const Tick now = task_->tick();
  return now > reading_.tick ? static_cast<double>(now - reading_.tick) * task_->servo_period() : 0.0;
}

void Sensor::acquire() {
  if (!interactive_) return;
  if (in_use_)
    throw NonFatalError(ErrorCode::busy, "another fiber reads this sensor", {task_->process_name(), name_, 0, 0});
  in_use_ = true;
}

void Sensor::initiate_reading(Tick measure_at) {
  if (!interactive_ || asked_) return;
  asked_ = link_->polled();
  link_->request({SensorRequestKind::reading, asked_ ? 0 : measure_at});
}

void Sensor::collect_reading() {
  fresh_ = false;
  if (link_->polled()) {
    asked_ = !link_->poll(arrived_);
    if (!asked_) take(arrived_);
  } else if (interactive_) {
    link_->receive(arrived_);
    take(arrived_);
  } else if (link_->latest(arrived_)) {
    take(arrived_);
  } else {
    reading_.error = {ErrorClass::non_fatal, ErrorCode::sensor_not_ready, {}};
  }
}

/// A reading that was made before the task's last configuration is not taken for one of it.
void Sensor::take(const SensorReading& reading) noexcept {
  if (reading.configuration < configuration_) return;
  fresh_ = reading.sequence != reading_.sequence;
  reading_ = reading;
}

}  // namespace mrroc
