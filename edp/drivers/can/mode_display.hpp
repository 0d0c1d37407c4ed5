#pragma once

#include <optional>

#include "canopen/drive_state.hpp"
#include "canopen/sdo.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// Whether a drive is in the mode that it has been told: its mode display (6061h), asked for by SDO until it shows that
/// mode, and not again before another one is wanted. A drive that does not have the object is believed. It sends
/// nothing itself, and its time is the servo's tick. Allocates nothing, never throws; one thread.
class ModeDisplay {
 public:
  static constexpr double kPause = 0.01;      ///< s, between two questions
  static constexpr double kAnswerTime = 0.1;  ///< s, to a question; then it is asked again

  /// `there`: its EDS file has the object. `period` in s.
  ModeDisplay(canopen::NodeId node, bool there, double period) noexcept;

  /// From now on this mode; what has been shown so far says nothing.
  void want(canopen::DriveMode mode) noexcept;
  canopen::DriveMode wanted() const noexcept { return wanted_; }
  /// False: the drive does not have it, no one can tell.
  bool tells() const noexcept { return there_; }
  /// It shows what is wanted, or cannot be asked.
  bool confirms() const noexcept { return !there_ || shown_ == static_cast<int>(wanted_); }
  /// What it has shown last since then.
  std::optional<int> shown() const noexcept { return shown_; }

  /// True: it is to be asked, `request` is to be sent.
  bool asks(Tick tick, can::Frame& request) noexcept;
  /// Looks at an SDO answer of its node; `next` is to be sent when it has data.
  void take(const can::Frame& frame, can::Frame& next) noexcept;

 private:
  canopen::NodeId node_;
  bool there_;
  Tick pause_ticks_, answer_ticks_;
  canopen::DriveMode wanted_ = canopen::DriveMode::none;
  std::optional<int> shown_;
  Tick asked_ = 0;
  Tick due_ = 0;  ///< the next question
  canopen::SdoTransfer transfer_;
};

}  // namespace mrroc::edp
