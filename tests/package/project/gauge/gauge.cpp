#include <mrroc/sensors/gauge.hpp>

namespace mrroc {

Gauge::Gauge(Task& task, const std::string& name) : Sensor(task, name, "gauge") {}

}  // namespace mrroc
