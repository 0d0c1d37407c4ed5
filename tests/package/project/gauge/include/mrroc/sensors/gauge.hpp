#pragma once

#include <mrroc/sensor.hpp>

namespace mrroc {

class Gauge : public Sensor {
 public:
  Gauge(Task& task, const std::string& name);
  double place() const noexcept { return value(0); }
};

}  // namespace mrroc
