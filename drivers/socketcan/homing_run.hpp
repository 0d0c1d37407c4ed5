#pragma once

#include <cstdint>

#include "drivers/socketcan/mode_display.hpp"
#include "edp/hardware.hpp"

namespace mrroc::edp {

/// Homing of one drive that finds its position on its own (CiA 402-2, 10: homing mode).
///
/// The master selects the homing mode (*selecting*), then starts the homing. The statusword may be stale for a short
/// time, and a drive that has homed before still reports "attained" (*starting*), until it reports "not attained"
/// (*moving*) or has reported "attained" for kInstantTime. Then the master selects the usual mode again (*leaving*);
/// homing is *attained* when the mode display confirms it. It has *failed* when the drive reports an error or
/// kLongestTime has passed.
///
///   none, attained, failed -> selecting    begin()
///   selecting -> starting                  the mode is confirmed; without a mode display: kSelectTime has passed
///   starting -> moving                     "not attained" is reported
///   starting -> leaving                    "attained" is reported for kInstantTime
///   moving -> leaving                      "attained" is reported
///   starting, moving -> attained           the same, of a drive without a mode display
///   starting, moving -> failed             an error is reported, or kLongestTime has passed
///   leaving -> attained                    the usual mode is confirmed
///   every state -> none                    cancel()
///
/// One thread; allocates nothing, never throws.
class HomingRun {
 public:
  enum class Phase : std::uint8_t { none, selecting, starting, moving, leaving, attained, failed };

  static constexpr double kSelectTime = 0.05;  ///< s, to change the mode of a drive without a mode display
  static constexpr double kStaleTime = 0.02;   ///< s after the start in which the statusword is not evaluated
  static constexpr double kInstantTime = 0.5;  ///< s of "attained" after which a drive that never moved is at home
  static constexpr double kLongestTime = 300;  ///< s after which homing has failed

  /// `usual`: the mode of normal operation. `period` in s.
  HomingRun(canopen::DriveMode usual, double period) noexcept;

  void begin(ModeDisplay& display) noexcept;
  void cancel() noexcept { phase_ = Phase::none; }
  /// Evaluates the statusword of an answer; once per cycle.
  void update(std::uint16_t statusword, ModeDisplay& display) noexcept;

  Phase phase() const noexcept { return phase_; }
  /// As in `HardwareInput`.
  Homing homing() const noexcept;
  bool runs() const noexcept { return homing() == Homing::running; }
  /// The commanded mode is homing.
  bool selects_homing() const noexcept { return runs() && phase_ != Phase::leaving; }
  /// The start bit of the controlword is set.
  bool has_started() const noexcept { return phase_ == Phase::starting || phase_ == Phase::moving; }
  /// Ticks since the last mode was selected.
  Tick ticks() const noexcept { return ticks_; }

 private:
  void update_motion(std::uint16_t statusword, ModeDisplay& display) noexcept;

  canopen::DriveMode usual_;
  Tick select_ticks_, stale_ticks_, instant_ticks_, longest_ticks_;
  Phase phase_ = Phase::none;
  Tick ticks_ = 0;
};

}  // namespace mrroc::edp
