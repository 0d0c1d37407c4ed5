#include "sim/errors/faulty_readings.hpp"

#include <algorithm>

#include "sim/errors/true_errors.hpp"

namespace mrroc::sim {

FaultyReadings::FaultyReadings(const config::ErrorsEntry& errors, const config::SensorEntry& sensor, double period)
    : wrench_(sensor.type == "force_torque"),
      range_(sensor.type == "ultrasonic" || sensor.type == "infrared"),
      period_(period),
      bias_(error_of_wrench(errors, sensor.name).bias),
      drift_(error_of_wrench(errors, sensor.name).drift),
      range_deviation_(errors.range_noise),
      noise_(errors.seed, sensor.name, "noise") {
  for (std::size_t i = 0; i < 6; ++i) deviation_[i] = i < 3 ? errors.force_noise : errors.torque_noise;
}

void FaultyReadings::apply(RawReading& reading) const noexcept {
  const double time = static_cast<double>(reading.tick) * period_;
  for (std::size_t i = 0; i < reading.count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    double& value = reading.values[i];
    if (wrench_ && i < 6) value += bias_[i] + drift_[i] * time + noise_.normal(deviation_[i], reading.tick, index);
    if (range_ && range_deviation_ > 0 && value > 0) {
      // a range finder reports -1 for no object: noise may not make one of a near object
      value = std::max(0.0, value + noise_.normal(range_deviation_, reading.tick, index));
    }
  }
}

}  // namespace mrroc::sim
