#pragma once

#include <array>

namespace mrroc {

/// The time-optimal stop of one axis with limited acceleration A and jerk J: from (p, v, a) to v = 0, a = 0. Three
/// phases of constant jerk: towards the deceleration, at -A (left out when the stop is short), back to zero. The stop
/// decelerates against w = v + a |a| / (2 J), the velocity at which the axis would arrive if only `a` were taken back.
/// An acceleration beyond A, which a macrostep may have, is first brought back at the jerk J.
///
/// Closed form: it cannot fail, allocates nothing and never throws.
class AxisStop {
 public:
  void plan(double p, double v, double a, double acceleration_max, double jerk_max) noexcept;

  /// Until rest, s.
  double duration() const noexcept { return duration_; }
  /// State t seconds after the start; from `duration()` on exactly (end_position, 0, 0).
  void at(double t, double& p, double& v, double& a) const noexcept;
  double end_position() const noexcept { return end_position_; }
  /// The range of positions that the stop passes, both ends included.
  double lowest() const noexcept { return lowest_; }
  double highest() const noexcept { return highest_; }
  /// Of the velocities that the stop passes, the one farthest from zero.
  double fastest() const noexcept { return fastest_; }

 private:
  struct Phase {
    double begin, p, v, a, jerk;
  };
  std::array<Phase, 3> phases_{};
  double duration_ = 0;
  double end_position_ = 0;
  double lowest_ = 0;
  double highest_ = 0;
  double fastest_ = 0;
};

}  // namespace mrroc
