#pragma once

#include <optional>

#include "canopen/drive_state.hpp"
#include "canopen/sdo.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// Checks that a drive is in the commanded mode: reads its mode display (6061h) by SDO until it shows that mode, and
/// not again before another mode is commanded. A drive without the object is assumed to be in the mode. It does no I/O:
/// its owner passes the frames. Time is the servo's tick. Allocates nothing, never throws; one thread.
class ModeDisplay {
 public:
  static constexpr double kPause = 0.01;      ///< s between two requests
  static constexpr double kAnswerTime = 0.1;  ///< s to an answer; then the request is repeated

  /// `object`: 6061h of its axis. `there`: the drive's EDS file has it. `period` in s.
  ModeDisplay(canopen::NodeId node, canopen::Object object, bool there, double period) noexcept;

  /// Commands this mode; what has been shown before is discarded.
  void want(canopen::DriveMode mode) noexcept;
  canopen::DriveMode wanted() const noexcept { return wanted_; }
  /// False: the drive does not have the object.
  bool is_available() const noexcept { return there_; }
  /// The commanded mode is shown, or the display is not available.
  bool confirms() const noexcept { return !there_ || shown_ == static_cast<int>(wanted_); }
  /// The mode shown last, since the last `want`.
  std::optional<int> shown() const noexcept { return shown_; }

  /// True: `request` is to be sent.
  bool asks(Tick tick, can::Frame& request) noexcept;
  /// An answer to the last request may still come.
  bool waits(Tick tick) const noexcept {
    return transfer_.status() == canopen::SdoTransfer::Status::waiting && tick < due_;
  }
  /// Takes an SDO answer of the node; `next` is to be sent unless it is empty.
  void take(const can::Frame& frame, can::Frame& next) noexcept;

 private:
  canopen::NodeId node_;
  canopen::Object object_;
  bool there_;
  Tick pause_ticks_, answer_ticks_;
  canopen::DriveMode wanted_ = canopen::DriveMode::none;
  std::optional<int> shown_;
  Tick asked_ = 0;
  Tick due_ = 0;  ///< the next request
  canopen::SdoTransfer transfer_;
};

}  // namespace mrroc::edp
