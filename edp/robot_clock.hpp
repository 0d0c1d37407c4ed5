#pragma once

#include <cstdint>

namespace mrroc::edp {

/// A package of a robot's controller: one of its periods has begun.
struct Beat {
  double time = 0;            ///< at the controller, s, from any origin
  std::int64_t received = 0;  ///< CLOCK_MONOTONIC, ns
};

/// The packages since the driver was opened.
struct BeatCounters {
  std::uint64_t packages = 0;  ///< received
  std::uint64_t lost = 0;      ///< periods of the controller whose package never came
  std::uint64_t doubled = 0;
  std::uint64_t late = 0;     ///< by more than a period of the controller
  std::uint64_t bunched = 0;  ///< received together with a newer one
};

/// The clock of a robot whose controller has a period of its own, which no other clock can hold: the servo ticks when
/// one of its packages comes, so that each period of the controller gets one set-point. On the real clock only.
class RobotClock {
 public:
  virtual ~RobotClock() = default;
  /// The controller's period, s: an integer number of servo periods, give or take what clocks differ. Constant after
  /// `Hardware::open`.
  virtual double period() const noexcept = 0;
  /// Waits until a package comes, or has come since the last call; of several the newest counts. `Hardware::read` then
  /// gives the readings of that package. False: none came before `deadline` (CLOCK_MONOTONIC, ns). Servo thread,
  /// between two ticks; allocates nothing.
  virtual bool wait(std::int64_t deadline, Beat& beat) noexcept = 0;
  /// Any thread.
  virtual BeatCounters counters() const noexcept = 0;
};

}  // namespace mrroc::edp
