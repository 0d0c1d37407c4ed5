#pragma once

#include <cstdint>

#include "canopen/drive_state.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// Commands the power of one drive: the controlword (CiA 402-2, 6.2).
///
///   off, waiting, on -> switching_on        enable(true)
///   resetting       -> resetting_first      enable(true)
///   switching_on   <-> waiting              the last step remains, and is not / is released
///   switching_on, waiting -> on             the drive reports operation enabled
///   switching_on, waiting, on -> off        enable(false)
///   resetting_first -> resetting            enable(false)
///   resetting       -> off                  the fault is cleared
///   resetting_first -> switching_on         the fault is cleared
///   every state     -> resetting            reset()
///
/// In the last step the drive releases its brake: it waits until all drives of the robot can take it. A drive that is
/// commanded off and still has power gets a quick stop for at most `switch_on_time`, so that a stop under way ends. One
/// thread; allocates nothing, never throws.
class DrivePower {
 public:
  enum class State : std::uint8_t {
    off,              ///< commanded to have no power
    switching_on,     ///< on the way to operation enabled
    waiting,          ///< one step before
    on,               ///< operation enabled has been reached
    resetting,        ///< a fault is being cleared
    resetting_first,  ///< the same, then the drive is switched on
  };

  static constexpr double kObeyTime = 0.5;  ///< s from the command of a stop to its begin

  /// Times in s.
  DrivePower(double switch_on_time, double period) noexcept;

  void enable(bool on, Tick tick) noexcept;
  void reset(Tick tick) noexcept;
  /// Takes the state that the drive reports.
  void update(canopen::DriveState now) noexcept;
  /// The controlword of this tick for a drive in state `now`. `reset_done`: its fault is cleared. `release`: it may
  /// take the last step.
  std::uint16_t command(canopen::DriveState now, bool reset_done, bool release) noexcept;

  State state() const noexcept { return state_; }
  /// Power is commanded, now or after a reset.
  bool wanted() const noexcept { return state_ != State::off && state_ != State::resetting; }
  bool resets() const noexcept { return state_ == State::resetting || state_ == State::resetting_first; }
  /// The time for the last `enable` or `reset` has passed.
  bool is_late(Tick tick) const noexcept { return tick > since_ + switch_on_ticks_; }
  Tick switch_on_ticks() const noexcept { return switch_on_ticks_; }
  /// State `now` is not the commanded one and its time is over: the drive did not switch on, did not stay on, or keeps
  /// its power.
  bool is_wrong(canopen::DriveState now, Tick tick) const noexcept;
  /// The drive keeps its power against its controlword.
  bool ignores_controlword(canopen::DriveState now) const noexcept;

  static bool has_power(canopen::DriveState now) noexcept {
    return now == canopen::DriveState::operation_enabled || now == canopen::DriveState::quick_stop_active;
  }

 private:
  std::uint16_t next_word(canopen::DriveState now, bool reset_done, bool release) noexcept;

  Tick switch_on_ticks_, obey_ticks_;
  State state_ = State::off;
  Tick since_ = 0;          ///< of `enable` or `reset`
  Tick stop_ticks_ = 0;     ///< since a stop was commanded, while the drive has power
  std::uint16_t word_ = 0;  ///< the last command
};

}  // namespace mrroc::edp
