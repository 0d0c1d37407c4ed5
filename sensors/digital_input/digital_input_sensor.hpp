#pragma once

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// One digital or analogue terminal. r is `level`, in the terminal's own unit. With s_k = (level_k > threshold) at
/// tick k and n the ticks of `debounce`, rounded up,
///
///     on_k = s_k       when s_k-n = ... = s_k, else on_k-1
///     rises_k          how often `on` has gone from 0 to 1 since the start or the last `bias`
///     level_k          unchanged
///
/// The first reading is the initial state: a terminal that is on at the start has not risen. It evaluates every tick,
/// so that no rise is lost between readings; a tick without a usable reading counts as the one before it.
class DigitalInputSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  bool continuous() const noexcept override { return true; }
  void track(const RawReading& r) noexcept override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  bool bias(const RawReading& r) noexcept override;

 private:
  bool above(const RawReading& r) const noexcept { return r.values[0] > threshold_; }

  double threshold_ = 0;
  Tick debounce_ = 0;
  bool started_ = false;
  bool on_ = false;
  bool last_ = false;    // s of the newest tick
  Tick last_since_ = 0;  // the tick since which s has been `last_`
  double rises_ = 0;
};

}  // namespace mrroc::vsp
