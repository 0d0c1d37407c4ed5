#pragma once

#include <array>

#include "edp/safety/fault.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Watches the encoders: a reading is invalid when it is not finite or farther from the last good one than the shaft
/// can have moved since. A shaft turns at most kMargin times as fast as the joints' velocity limits let it turn at
/// home: the ratios of a transmission differ elsewhere, and an external push may be fast.
///
/// After a jump the allowed distance does not grow: the drives are off and the shaft is at rest, so the reading must
/// return to the old position, or the position is lost. The servo's thread; allocates nothing, never throws.
class EncoderWatch {
 public:
  static constexpr double kMargin = 6;

  struct Finding {
    int axis = -1;         ///< -1: the readings are plausible
    FaultDetail detail{};  ///< how far from the last good reading and how far at most, rad; or NotFinite
  };

  /// `model`: any of the robot's; `period` in s.
  EncoderWatch(const RobotModel& model, double period) noexcept;

  /// Takes the readings (rad) of the time `time`, which need not be later than the last one's: drives may repeat them.
  /// They are judged by the time (ticks) from the last good reading until `now`: after a silence the first reading may
  /// be old, but the axis could move during all that time.
  Finding check(const JointVector& motors, double time, double now) noexcept;
  /// From now on the same readings are greater by `shift`.
  void shift(const JointVector& shift) noexcept { good_ += shift; }

 private:
  std::size_t count_;
  std::array<double, kMaxJoints> way_{};  ///< largest motion in a tick, rad
  JointVector good_;                      ///< the last good readings; empty before the first
  double time_ = 0;                       ///< of `good_`, ticks
  double ticks_ = 1;                      ///< ticks for the motion since then
  bool jumped_ = false;
};

}  // namespace mrroc::edp
