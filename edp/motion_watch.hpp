#pragma once

#include <array>

#include "edp/snapshot.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// Watches whether the robot moves as it is told to, sooner than the following error does:
///
/// - a joint faster than kOverspeed times its velocity limit, over kReadings readings, has run away: its drive no
/// longer obeys;
/// - a shaft that reads the very same position while its set-point goes on by `stuck_max` is jammed, or its encoder has
/// died and the regulator will push it faster and faster.
///
/// The servo's thread; allocates nothing, never throws.
class MotionWatch {
 public:
  static constexpr double kOverspeed = 1.15;
  /// A single difference trembles by an increment of the encoder, and by what the regulator does about it.
  static constexpr std::size_t kReadings = 4;

  /// `period` in s.
  explicit MotionWatch(double period) noexcept : period_(period) {}

  /// The drives have been switched on, or joints and shafts are counted otherwise from now on.
  void reset() noexcept { readings_ = 0; }
  /// Takes joints (rad or m) and shafts (rad) as they were read at `read_tick`, and the set-points of the shafts. The
  /// first axis that is too fast, else one that is stuck (`moves`: it is commanded, not stopping); code none: all is
  /// well.
  Fault look(const std::vector<AxisParameters>& axes, const JointVector& joints, const JointVector& motors,
             const JointVector& desired_motors, Tick read_tick, bool moves) noexcept;

 private:
  Fault look_at_speed(const std::vector<AxisParameters>& axes, const JointVector& joints, Tick read_tick) noexcept;
  Fault look_at_shafts(const std::vector<AxisParameters>& axes, const JointVector& motors,
                       const JointVector& desired_motors) noexcept;

  double period_;
  struct Reading {
    Tick tick = 0;
    JointVector joints;
  };
  std::array<Reading, kReadings> ring_;
  std::size_t readings_ = 0;   ///< so far; number n is in place n % kReadings
  JointVector motors_;         ///< where each shaft came to last
  JointVector desired_there_;  ///< its set-point when it came there
};

}  // namespace mrroc::edp
