#include <vsp/parameters.hpp>
#include <vsp/shell.hpp>

namespace mrroc::vsp {

/// place = (r - zero) / scale.
class GaugeSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double /*servo_period*/) override {
    scale_ = number(entry, "scale");
  }
  void aggregate(const RawReading& r, SensorReading& v) noexcept override {
    v.values[0] = (r.values[0] - zero_) / scale_;
  }
  bool bias(const RawReading& r) noexcept override {
    zero_ = r.values[0];
    return true;
  }

 private:
  double scale_ = 1;
  double zero_ = 0;
};

}  // namespace mrroc::vsp

MRROC_VSP(mrroc::vsp::GaugeSensor)
