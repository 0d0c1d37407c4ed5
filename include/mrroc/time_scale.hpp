#pragma once

namespace mrroc {

/// The ratio of a generator's own time to the time of the clock, at one instant: velocities scale with `factor`.
struct TimeScale {
  double factor = 1;  ///< 0..1
  double rate = 0;    ///< its derivative, 1/s of the clock's time

  bool is_real_time() const noexcept { return factor == 1 && rate == 0; }
};

}  // namespace mrroc
