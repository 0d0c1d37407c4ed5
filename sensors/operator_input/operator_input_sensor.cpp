#include "sensors/operator_input/operator_input_sensor.hpp"

#include "config/entries/operator_answer.hpp"
#include "sensors/operator_input/operator_source.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

void OperatorInputSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  const double min = number(entry, "min"), max = number(entry, "max");
  if (min > max) refuse(entry, "min", std::to_string(min), "at most max, " + std::to_string(max));
}

std::unique_ptr<Source> OperatorInputSensor::open_source(const SourceContext& context) {
  if (!config::asks_operator(context.entry)) return nullptr;  // the framework's
  auto source = std::make_unique<OperatorSource>(context.entry, *context.domain, *context.clock,
                                                 context.deployment.name + "/" + context.entry.name,
                                                 context.deployment.start_timeout);
  operator_ = source.get();
  return source;
}

void OperatorInputSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  const bool answered = r.values[0] > zero_;
  v.values[0] = answered ? 1 : 0;
  v.values[1] = answered ? r.values[1] : 0;
}

bool OperatorInputSensor::bias(const RawReading& r) noexcept {
  zero_ = r.values[0];
  if (operator_ != nullptr) operator_->ask(r.tick);
  return true;
}

}  // namespace mrroc::vsp
