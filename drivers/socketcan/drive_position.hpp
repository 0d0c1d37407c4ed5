#pragma once

#include <cstdint>

namespace mrroc::edp {

/// Position of a drive's shaft, computed from the drive's 32-bit counter:
///
///   position = raw * rad_per_unit + offset
///
/// `raw` is the last received count with its wraps; when a SYNC is not answered it is extrapolated by the increment
/// between the last two counts. The effect of the first feedback of a cycle can be reverted. One thread; allocates
/// nothing, never throws.
class DrivePosition {
 public:
  /// `rad_per_unit` is negative when the drive counts in the opposite direction. `absolute`: the encoder reports its
  /// position at power-on. `jump`: more units in one tick than the shaft can move; during homing such a step is a new
  /// origin of the counter.
  DrivePosition(double rad_per_unit, bool absolute, std::int64_t jump) noexcept
      : rad_per_unit_(rad_per_unit), absolute_(absolute), jump_(jump) {}

  double position() const noexcept { return static_cast<double>(now_.raw) * rad_per_unit_ + now_.offset; }  ///< rad
  std::int64_t raw() const noexcept { return now_.raw; }
  double offset() const noexcept { return now_.offset; }  ///< rad
  double units_of(double position) const noexcept { return (position - now_.offset) / rad_per_unit_; }
  /// A count has been received since the last `assume_position`.
  bool known() const noexcept { return now_.known; }

  /// A SYNC is about to be sent.
  void expect() noexcept;
  /// Saves the state that `revert` restores.
  void save() noexcept { saved_ = now_; }
  void revert() noexcept { now_ = saved_; }
  /// Takes a received count. `homes`: the drive may set a new origin.
  void take(std::int64_t raw, bool homes) noexcept;
  /// Extrapolates one period.
  void extrapolate() noexcept { now_.raw += now_.increment; }

  /// Discards the last count, which may be wrong: the next one is compared with `position`, rad.
  void assume_position(double position) noexcept;
  void add_origin(double shift) noexcept { now_.offset += shift; }  ///< rad

  /// The drive has restarted: its count is relative to the position at power-on until `found`.
  bool lost() const noexcept { return lost_; }
  void lose() noexcept { lost_ = true; }
  void found() noexcept { lost_ = false; }

  /// Stores the present count as the one to hold while other drives are switched on.
  void hold_here() noexcept { now_.held = now_.raw; }
  std::int64_t held() const noexcept { return now_.held; }
  double held_error() const noexcept { return static_cast<double>(now_.held - now_.raw) * rad_per_unit_; }  ///< rad

 private:
  struct Count {
    std::int64_t raw = 0;
    std::int64_t received = 0;   ///< the last received count; `raw` unless extrapolated
    std::int64_t age = 0;        ///< SYNCs sent since
    std::int64_t increment = 0;  ///< per SYNC
    std::int64_t wraps = 0;      ///< of the 32-bit counter
    std::int64_t held = 0;
    double offset = 0;
    bool known = false;
  };
  std::int64_t unwrapped(std::int64_t raw) noexcept;

  double rad_per_unit_;
  bool absolute_;
  std::int64_t jump_;
  Count now_, saved_;
  bool lost_ = false;  // not reverted: a restart stays a restart
};

}  // namespace mrroc::edp
