#include <vsp/parameters.hpp>
#include <vsp/shell.hpp>

/// angle = raw - zero.
class ProtractorSensor final : public mrroc::vsp::VirtualSensor {
 public:
  void configure(const mrroc::config::SensorEntry& entry, double /*servo_period*/) override {
    zero_ = mrroc::vsp::number(entry, "zero");
  }
  void aggregate(const mrroc::vsp::RawReading& raw, mrroc::SensorReading& reading) noexcept override {
    reading.values[0] = raw.values[0] - zero_;
  }

 private:
  double zero_ = 0;
};

MRROC_VSP(ProtractorSensor)
