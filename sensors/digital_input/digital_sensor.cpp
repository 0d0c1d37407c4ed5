#include "mrroc/sensors/digital_input.hpp"

namespace mrroc {

DigitalSensor::DigitalSensor(Task& task, const std::string& name) : Sensor(task, name, "digital_input") {}

bool Risen::holds() {
  if (input_->rises() < origin_) origin_ = 0;  // another program has set the count to zero
  return input_->rises() > origin_;
}

}  // namespace mrroc
